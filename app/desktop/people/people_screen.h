// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/person.h"
#include "desktop/frame/screen.h"

#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace chiron::desktop {

class FormDialog;
class PeopleModel;
class StatePanel;

/// The administrator's screen for people: find, add, import, rename, change roles, disable, reset a password,
/// export stored data, erase. Every action goes through AccountService, which checks and audits it.
class PeopleScreen final : public Screen {
    Q_OBJECT
public:
    PeopleScreen(AppContext& context, const Place& place);

    QString title() const override;
    QString help() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;

    /// Opens the import dialog for a chosen file. Tests call it directly, without a file dialog.
    void importRoster(const QString& file);
    /// Writes an empty list with headings, to be filled in with a spreadsheet.
    void saveTemplate(const QString& file);
    /// Writes everything held about the chosen person to this file.
    void exportTo(const QString& file);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* headRow();
    QWidget* listPart();
    QWidget* actionPart();
    void load();
    void loaded(core::Result<std::vector<database::Person>> people);
    void find(const QString& text);
    void fitColumns();
    void choose(database::PersonId person);
    const database::Person* chosen() const; ///< null if nobody is chosen
    void renewActions();
    void open(FormDialog* dialog);
    void addPerson();
    void editPerson();
    void editRoles();
    void toggleEnabled();
    void setEnabledOf(const database::Person& person, bool enabled);
    void resetPassword();
    void askExport();
    void erase();
    void eraseParticipant();
    void askRoster();
    void askTemplate();
    void showEarlierNames();

    QLineEdit* m_search = nullptr;
    StatePanel* m_panel = nullptr;
    QTableView* m_table = nullptr;
    PeopleModel* m_model = nullptr;
    QSortFilterProxyModel* m_found = nullptr;
    QLabel* m_chosenName = nullptr;
    QLabel* m_chosenWords = nullptr;
    QLabel* m_earlier = nullptr;
    QPushButton* m_edit = nullptr;
    QPushButton* m_roles = nullptr;
    QPushButton* m_enable = nullptr;
    QPushButton* m_reset = nullptr;
    QPushButton* m_export = nullptr;
    QPushButton* m_erase = nullptr;
    database::PersonId m_chosen = 0;
};

} // namespace chiron::desktop
