// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/roster_import.h"
#include "desktop/people/form_dialog.h"

#include <string>

class QLabel;
class QRadioButton;

namespace chiron::desktop {

class SlipsPanel;
class StatePanel;

/// Imports a list of people from CSV. It first shows what would happen with each line and which lines contain
/// errors; then it imports all of them or none. Generated passwords are shown once, for printing.
/// Thread: GUI.
class RosterDialog final : public FormDialog {
    Q_OBJECT
public:
    /// `bytes` is the content of the file; `fileName` is its name for display.
    RosterDialog(AppContext& context, const QString& fileName, std::string bytes, QWidget* parent);

    void reject() override; ///< warns once before it discards passwords that nobody has printed or saved

protected:
    void submit() override;

private:
    QWidget* existingChoice();
    QWidget* roleChoice(const std::string& word); ///< role for a word of the list
    void askRoles(const database::Roster& roster);
    database::RosterExisting existing() const;
    void load();
    void showPlan(const database::RosterPlan& plan);
    void showDone(database::RosterOutcome outcome);
    QWidget* problemList(const database::Roster& roster) const;

    std::string m_bytes;
    int m_changes = 0;
    int m_asked = 0;                 ///< number of times the list was read, to discard outdated answers
    database::RoleWords m_roleWords; ///< as chosen in this dialog
    QWidget* m_roles = nullptr;      ///< the role choices; null if every word names a role
    QLabel* m_read;
    QWidget* m_existing;
    QRadioButton* m_update = nullptr;
    StatePanel* m_panel;
    SlipsPanel* m_slips = nullptr;
    bool m_warned = false;
};

/// Describes an error in a list of people.
QString rosterProblemWords(const database::RosterProblem& problem);

} // namespace chiron::desktop
