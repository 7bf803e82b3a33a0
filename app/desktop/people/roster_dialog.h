// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/user_csv.h"
#include "desktop/people/form_dialog.h"

#include <string>

class QLabel;

namespace chiron::desktop {

class StatePanel;

/// Imports a list of people from CSV: shows first who would be added and what is wrong in which line; then all are added,
/// or nobody. GUI thread.
class RosterDialog final : public FormDialog {
    Q_OBJECT
public:
    /// `text` is the file's content, `fileName` what people call it.
    RosterDialog(AppContext& context, const QString& fileName, std::string text, QWidget* parent);

protected:
    void submit() override;

private:
    void load();
    void showRoster(const database::Roster& roster);
    QWidget* peopleTable(const database::Roster& roster) const;
    QWidget* problemList(const database::Roster& roster) const;

    std::string m_text;
    int m_people = 0;
    StatePanel* m_panel;
};

/// One thing that is wrong in a list of people, in words.
QString rosterProblemWords(const database::RosterProblem& problem);

} // namespace chiron::desktop
