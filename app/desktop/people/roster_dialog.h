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

/// Imports a list of people from CSV: shows first what would become of each line and what is wrong in which; then all of it is
/// done, or nothing. Passwords that were made are shown once, to be printed. GUI thread.
class RosterDialog final : public FormDialog {
    Q_OBJECT
public:
    /// `bytes` is the file's content, `fileName` what people call it.
    RosterDialog(AppContext& context, const QString& fileName, std::string bytes, QWidget* parent);

    void reject() override; ///< passwords that nobody has taken: only when asked twice

protected:
    void submit() override;

private:
    QWidget* existingChoice();
    QWidget* roleChoice(const std::string& word); ///< what a word of the list stands for
    void askRoles(const database::Roster& roster);
    database::RosterExisting existing() const;
    void load();
    void showPlan(const database::RosterPlan& plan);
    void showDone(database::RosterOutcome outcome);
    QWidget* problemList(const database::Roster& roster) const;

    std::string m_bytes;
    int m_changes = 0;
    int m_asked = 0; ///< how often the list was read: an answer to an earlier question is not shown
    database::RoleWords m_roleWords; ///< as chosen here
    QWidget* m_roles = nullptr;      ///< the choices; null while every word is a role
    QLabel* m_read;
    QWidget* m_existing;
    QRadioButton* m_update = nullptr;
    StatePanel* m_panel;
    SlipsPanel* m_slips = nullptr;
    bool m_warned = false;
};

/// One thing that is wrong in a list of people, in words.
QString rosterProblemWords(const database::RosterProblem& problem);

} // namespace chiron::desktop
