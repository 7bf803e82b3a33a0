// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"
#include "desktop/home/home_data.h"

class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

class StatePanel;

/// Where everybody starts: what their roles want first (experience.md). Who holds several roles sees each one's part, the
/// own training first; who is no trainee may train as well, and finds that after their own part, or before it while the site has nobody
/// else. From here a running exercise is two actions away.
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
    void addAdmin(QVBoxLayout& column, const HomeData& home);
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
    QWidget* stateCard(const QString& screen, const QString& title, const QString& text, const char* noticeKind, const QString& notice,
                       const QString& action);
    QPushButton* opener(const QString& text, const QString& screen, const QVariantMap& parameters = {}, const char* kind = "");

    StatePanel* m_panel;
    QPushButton* m_first = nullptr; ///< gets the focus
};

} // namespace chiron::desktop
