// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"
#include "desktop/home/home_data.h"

class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

class StatePanel;

/// Where everybody starts, ordered by what is to be done (experience.md): what an administrator has to see to, the own next step, the
/// parts of the other roles, and last what is in order. Who is no trainee may train as well, and finds that after the part of their role;
/// while the site has nobody else it comes first. From here a running exercise is two actions away.
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
    void addComments(QVBoxLayout& column); ///< the way to all of them, read ones too
    void addTrainee(QVBoxLayout& column, const HomeData& home);
    void addTrainer(QVBoxLayout& column, const HomeData& home);
    void addResearcher(QVBoxLayout& column);
    void addAdmin(QVBoxLayout& column, const HomeData& home, bool thatAsk); ///< the cards that ask for something, or those in order
    QWidget* continueCard(const HomeData& home);
    /// For who has not trained yet: straight to a few trials that do not count. Null where there is no exercise.
    QWidget* tryCard(const HomeData& home);
    QVBoxLayout* besidePicture(QVBoxLayout& card, const catalogue::ExerciseLevel& level); ///< for the words; no picture where the text is large
    QPushButton* tryButton(const session::LevelStanding& level, const char* kind);
    void addOwnTraining(QVBoxLayout& column, const HomeData& home); ///< of who is no trainee
    QString lastResult(const HomeData& home, const session::LevelStanding& next) const; ///< empty: none yet
    QWidget* progressCard(const HomeData& home);
    QWidget* peopleCard(const HomeData& home);
    /// A card that says how something is and opens its screen.
    struct StateCard {
        QString screen, title, text;
        const char* noticeKind;
        QString notice;
        QString action;
        bool asks = false; ///< somebody has to do something about it
    };
    QWidget* stateCard(const StateCard& card);
    std::vector<StateCard> adminCards(const HomeData& home) const;
    QPushButton* opener(const QString& text, const QString& screen, const QVariantMap& parameters = {}, const char* kind = "");

    StatePanel* m_panel;
    QPushButton* m_first = nullptr; ///< gets the focus
};

} // namespace chiron::desktop
