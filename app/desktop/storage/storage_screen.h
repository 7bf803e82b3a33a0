// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/upkeep/upkeep.h"
#include "desktop/frame/background.h"
#include "desktop/frame/screen.h"
#include "desktop/storage/storage_facts.h"

#include <map>
#include <optional>

class QLabel;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace chiron::desktop {

class AutomaticCard;
class StatePanel;
class TaskStrip;

/// Manages storage: free space, backups, verification, restore, export. One long task runs at a time, with
/// progress and Cancel. For administrators; the data layer refuses others.
class StorageScreen final : public Screen {
    Q_OBJECT
public:
    StorageScreen(AppContext& context, const Place& place);

    QString title() const override;
    void enter() override;
    bool mayLeave() override;
    bool isBusy() const override { return m_restoring; }
    std::vector<ScreenCommand> commands() override;
    QString help() const override;

signals:
    void taskEnded(); ///< a backup, verification, export or restore, with any result

private:
    enum class Task { none, backup, verifyBackup, verifySite, exportSite };

    QWidget* buildPage();
    void addRoom(QVBoxLayout& column);
    void addBackups(QVBoxLayout& column);
    void addAutomatic(QVBoxLayout& column);
    void addVerify(QVBoxLayout& column);
    void addExport(QVBoxLayout& column);
    QPushButton* addButton(QLayout& row, const QString& name, const QString& text, const char* kind,
                           const QString& icon, void (StorageScreen::*act)());

    void load();
    void show(StorageFacts facts);
    void showBackups();
    void showReport(const database::VerifyReport& report);
    void showButtons();
    const session::BackupEntry* selected() const;

    void backUp();
    void chooseFolder();
    void savePlan(const database::BackupPlan& plan);
    QString folder() const; ///< the folder for backups
    void verifyBackup();
    void verifySite();
    void exportSite();
    void askRestore();
    void restore(database::RestoreRequest request);
    void restored(const core::Result<database::RestoreInfo>& result);
    void runSnapshot(Task task, const QString& folder);
    void runVerify(Task task, const std::string& backupFolder);
    void endTask();

    StatePanel* m_panel;
    TaskStrip* m_strip;
    Task m_task = Task::none;
    bool m_restoring = false;
    StorageFacts m_facts;
    /// By folder: whether the backup passed its check, since this screen was opened.
    std::map<std::string, bool> m_checked;
    QVBoxLayout* m_notices = nullptr;
    QVBoxLayout* m_reportBox = nullptr;
    AutomaticCard* m_automatic = nullptr;
    QLabel* m_database = nullptr;
    QLabel* m_recordings = nullptr;
    QLabel* m_free = nullptr;
    QLabel* m_place = nullptr;
    QTableWidget* m_backups = nullptr;
    QTableWidget* m_findings = nullptr;
    QPushButton* m_backUp = nullptr;
    QPushButton* m_choose = nullptr;
    QPushButton* m_verifyBackup = nullptr;
    QPushButton* m_restore = nullptr;
    QPushButton* m_verifySite = nullptr;
    QPushButton* m_export = nullptr;
    QPushButton* m_hadFocus = nullptr; ///< while a task runs: the button that started it
};

} // namespace chiron::desktop
