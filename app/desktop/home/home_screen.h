// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"
#include "desktop/home/home_data.h"

class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

class StatePanel;

/// The screen after login, ordered by what needs to be done (experience.md): tasks for an administrator, the
/// person's own next step, the parts of the other roles, and last what is in order. People without the
/// trainee role may train as well and find that below the part of their role, or first as long as the site
/// has no other people. A running exercise is two actions away from here.
class HomeScreen final : public Screen {
    Q_OBJECT
public:
    HomeScreen(AppContext& context, const Place& place);

    QString title() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;
    QString help() const override;

private:
    void load();
    void show(const HomeData& home);
    void addRecovered(QVBoxLayout& column, const HomeData& home);
    void addRecoveryCode(QVBoxLayout& column, const HomeData& home);
    void addCommented(QVBoxLayout& column, const HomeData& home);
    void addComments(QVBoxLayout& column); ///< button that opens all comments, read ones too
    void addTrainee(QVBoxLayout& column, const HomeData& home);
    void addTrainer(QVBoxLayout& column, const HomeData& home);
    void addResearcher(QVBoxLayout& column);
    void addStudies(QVBoxLayout& column);
    /// `thatAsk`: the cards that need action; otherwise those in order.
    void addAdmin(QVBoxLayout& column, const HomeData& home, bool thatAsk);
    QWidget* continueCard(const HomeData& home);
    /// For people who have not trained yet: starts a few trials that do not count. Null if there is no
    /// exercise.
    QWidget* tryCard(const HomeData& home);
    /// Column for text beside a picture; no picture if the text is large.
    QVBoxLayout* besidePicture(QVBoxLayout& card, const catalogue::ExerciseLevel& level);
    QPushButton* tryButton(const session::LevelStanding& level, const char* kind);
    void addOwnTraining(QVBoxLayout& column, const HomeData& home); ///< for people without the trainee role
    /// Empty if there is none yet.
    QString lastResult(const HomeData& home, const session::LevelStanding& next) const;
    QWidget* progressCard(const HomeData& home);
    QWidget* peopleCard(const HomeData& home);
    /// A card that describes the state of something and opens its screen.
    struct StateCard {
        QString screen, title, text;
        const char* noticeKind;
        QString notice;
        QString action;
        bool asks = false; ///< someone has to act on it
    };
    QWidget* stateCard(const StateCard& card);
    std::vector<StateCard> adminCards(const HomeData& home) const;
    QPushButton* opener(const QString& text, const QString& screen, const QVariantMap& parameters = {},
                        const char* kind = "");

    StatePanel* m_panel;
    QPushButton* m_first = nullptr; ///< gets the focus
};

} // namespace chiron::desktop
