// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/frame/screen.h"
#include "desktop/progress/progress_filter.h"
#include "session/group_standing.h"

#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace chiron::desktop {

class ProgressTable;
class StatePanel;

/// A trainer's overview of a group: each person's standing at each exercise, their latest training and their
/// next step. It leads to a person's sessions at an exercise. The place is a ProgressFilter, plus {person,
/// exercise} for the chosen cell.
/// Thread: GUI.
class ProgressScreen final : public Screen {
    Q_OBJECT
public:
    ProgressScreen(AppContext& context, const Place& place);

    QString title() const override;
    QString help() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;

private:
    QWidget* buildHead();
    QWidget* buildFilters();
    QWidget* buildActions();
    void load();
    void take(core::Result<std::vector<session::PersonStanding>> people);
    void readFilter();
    void clearFilter();
    void showPeople();
    void showActions();
    void noteState();
    void openSessions();
    void openResults();

    ProgressFilter m_filter;
    database::PersonId m_wanted = 0; ///< person to select after loading
    std::string m_wantedExercise;
    std::vector<session::PersonStanding> m_people; ///< everybody, independent of the filter
    bool m_showing = false;
    QLabel* m_count = nullptr;
    QLineEdit* m_names = nullptr;
    QComboBox* m_part = nullptr;
    QPushButton* m_clear = nullptr;
    StatePanel* m_panel = nullptr;
    ProgressTable* m_table = nullptr;
    QLabel* m_chosen = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_results = nullptr;
};

} // namespace chiron::desktop
