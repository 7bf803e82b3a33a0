// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/integrity/file_health.h"
#include "database/upkeep/upkeep.h"
#include "desktop/frame/screen.h"
#include "session/backup_list.h"

#include <map>
#include <optional>

class QLabel;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace chiron::desktop {

class ScrollPage;
class StatePanel;

/// The first screen if the site's file is damaged or missing. It says what is wrong, lists and checks the
/// backups in the folders that the station knows, and restores the chosen one. The data layer decides who may
/// do so and whether a backup is good. The place is {missing, detail}.
class RestoreScreen final : public Screen {
    Q_OBJECT
public:
    RestoreScreen(AppContext& context, const Place& place);

    /// The place for a file in this damaged or missing state.
    static Place placeFor(const database::FileState& state);

    QString title() const override;
    QString help() const override;
    void enter() override;
    bool mayLeave() override;
    bool isBusy() const override { return m_restoring; }
    std::vector<ScreenCommand> commands() override;

protected:
    void resizeEvent(QResizeEvent* event) override;

signals:
    void looked(); ///< every backup in the list has been checked

private:
    enum class Look { waiting, whole, unusable };

    bool isMissing() const;
    void addHead(QVBoxLayout& column);
    QWidget* buildTable();
    void addActions(QVBoxLayout& column);
    void find();
    void show(std::vector<session::BackupEntry> backups);
    void put(std::size_t row, Look look, const QString& why);
    void fitColumns();
    void lookAt(std::size_t row);
    void chooseFile();
    void takeFile(const QString& file);
    const session::BackupEntry* selected() const;
    void showButtons();
    void askRestore();
    void restore(database::RestoreRequest request);
    void restored(const core::Result<database::RestoreInfo>& result);
    void openAgain();

    ScrollPage* m_page;
    StatePanel* m_panel = nullptr;
    QTableWidget* m_table = nullptr;
    QLabel* m_reason = nullptr; ///< why the selected backup cannot be used
    QPushButton* m_restore = nullptr;
    QPushButton* m_choose = nullptr;
    QPushButton* m_again = nullptr;
    QPushButton* m_anew = nullptr; ///< shown if the file is missing
    std::vector<session::BackupEntry> m_backups;
    std::map<std::string, Look> m_looks;  ///< keyed by folder
    std::map<std::string, QString> m_why; ///< reasons for the unusable ones, keyed by folder
    bool m_restoring = false;
};

} // namespace chiron::desktop
