// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/upkeep/upkeep.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/file_folder.h"
#include "desktop/sessions/session_words.h"
#include "desktop/storage/backup_place.h"
#include "desktop/storage/restore_dialog.h"
#include "desktop/storage/storage_screen.h"
#include "desktop/storage/task_strip.h"
#include "desktop/widgets/state_panel.h"
#include "session/integrity_check.h"

#include <QDir>
#include <QFileDialog>
#include <QPointer>
#include <QPushButton>
#include <QTableWidget>

namespace chiron::desktop {

namespace {

/// A new folder that does not exist yet, named after the current time.
QString newFolder(const QString& place, const QString& kind) {
    const QString base = QDir(place).filePath(
        QStringLiteral("chiron-%1-%2")
            .arg(kind, QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss"))));
    QString name = base;
    for (int i = 2; QFileInfo::exists(name); ++i)
        name = QStringLiteral("%1-%2").arg(base).arg(i);
    return name;
}

/// Reports progress in thousandths, because a token counts in int.
database::VerifyWatch watchFor(WorkToken& token) {
    return [&token](std::uint64_t done, std::uint64_t of) {
        token.setProgress(of > 0 ? static_cast<int>(done * 1000 / of) : 0, 1000);
        return !token.cancelled();
    };
}

} // namespace

void StorageScreen::enter() {
    connect(&context(), &AppContext::backupEnded, this, [this] {
        if (m_task == Task::none && !m_restoring)
            load();
    });
    load();
}

QString StorageScreen::folder() const {
    return m_facts.backupFolder.empty() ? backupPlace(context())
                                        : QString::fromStdString(m_facts.backupFolder);
}

bool StorageScreen::mayLeave() {
    if (m_restoring) {
        context().messages().information(tr("Wait until the restore has finished."));
        return false;
    }
    // It continues and reports its end, but can no longer show results on this screen.
    if (m_task != Task::none)
        context().messages().information(tr("The task that you started continues in the background."));
    return true;
}

std::vector<ScreenCommand> StorageScreen::commands() {
    std::vector<ScreenCommand> list;
    for (QPushButton* button : {m_backUp, m_verifySite, m_verifyBackup, m_restore, m_export, m_choose})
        list.push_back({button->text(), {}, [button] { button->click(); }});
    return list;
}

void StorageScreen::load() {
    if (m_panel->state() != StatePanel::State::content)
        m_panel->showLoading(tr("Checking the storage …"));
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor(),
         folder = backupPlace(context()).toStdString()](WorkToken&) {
            return readStorageFacts(database, actor, folder);
        },
        [this](core::Result<StorageFacts> facts) {
            if (facts)
                show(std::move(*facts));
            else
                m_panel->showError(tr("The storage could not be checked."), facts.error(),
                                   [this] { load(); });
        });
}

const session::BackupEntry* StorageScreen::selected() const {
    const int row = m_backups->currentRow();
    return row >= 0 && row < static_cast<int>(m_facts.backups.size())
               ? &m_facts.backups[static_cast<std::size_t>(row)]
               : nullptr;
}

void StorageScreen::endTask() {
    m_task = Task::none;
    m_strip->stop();
    showButtons();
    emit taskEnded();
}

void StorageScreen::backUp() {
    runSnapshot(Task::backup, newFolder(folder(), QStringLiteral("backup")));
}

void StorageScreen::exportSite() {
    auto* dialog = new QFileDialog(this, tr("Folder for the export"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("site_exports"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& place) {
        runSnapshot(Task::exportSite, newFolder(place, QStringLiteral("export")));
    });
    dialog->open();
}

void StorageScreen::chooseFolder() {
    auto* dialog = new QFileDialog(this, tr("Folder for backups"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("backups"),
                      context().settings().backupFolder());
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& place) {
        // The folder is also stored for the station, which is the only place to find it when the site cannot
        // be opened.
        setBackupPlace(context(), place);
        database::BackupPlan plan = m_facts.standing.plan;
        plan.folder = place.toStdString();
        savePlan(plan);
    });
    dialog->open();
}

void StorageScreen::savePlan(const database::BackupPlan& plan) {
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor(), plan](WorkToken&) {
            return database.write([&](database::WriteContext& writing) {
                return database::Upkeep::setBackupPlan(writing.connection(), actor, plan);
            });
        },
        [this](const core::Result<void>& saved) {
            if (!saved)
                context().messages().error(tr("The plan for automatic backups was not saved."),
                                           saved.error());
            load();
        });
}

void StorageScreen::runSnapshot(Task task, const QString& folder) {
    m_task = task;
    const bool backup = task == Task::backup;
    AppContext& app = context();
    const QPointer<StorageScreen> screen(this);
    QDir().mkpath(QFileInfo(folder).absolutePath());
    const auto token = app.background().run(
        &app, // so that people who moved to another screen get the result as well
        [&database = app.site().database(), actor = app.actor(), backup,
         name = folder.toStdString()](WorkToken& working) {
            return backup ? database::Upkeep::backup(database, actor, name, &working.flag())
                          : database::Upkeep::exportSite(database, actor, name, &working.flag());
        },
        [&app, screen, backup](const core::Result<database::SnapshotInfo>& info) {
            const QLocale locale = app.locale();
            if (info)
                app.messages().done(
                    (backup ? tr("The backup is made and checked: %1 in %2.")
                            : tr("The site is exported and checked: %1 in %2."))
                        .arg(SessionWords::bytes(info->bytes, locale), QString::fromStdString(info->folder)));
            else if (info.error().code == core::ErrorCode::cancelled)
                app.messages().information(backup ? tr("The backup was stopped; nothing was saved.")
                                                  : tr("The export was stopped; nothing was saved."));
            else
                app.messages().error(
                    backup ? tr("The backup was not made.") : tr("The site was not exported."), info.error());
            if (screen) {
                screen->endTask();
                screen->load();
            }
        });
    m_strip->start(backup ? tr("Making a backup …") : tr("Exporting the site …"), token);
    showButtons();
}

void StorageScreen::verifyBackup() {
    if (const session::BackupEntry* backup = selected())
        runVerify(Task::verifyBackup, backup->folder);
}

void StorageScreen::verifySite() {
    runVerify(Task::verifySite, {});
}

void StorageScreen::runVerify(Task task, const std::string& backupFolder) {
    m_task = task;
    const auto token = context().background().run(
        this,
        [file = context().site().file().toStdString(), options = context().site().options(),
         backupFolder](WorkToken& working) {
            return backupFolder.empty()
                       ? session::verifyEverything(file, options, watchFor(working))
                       : session::verifyBackup(backupFolder, file, options, watchFor(working));
        },
        [this, backupFolder](const database::VerifyReport& report) {
            showReport(report);
            if (!backupFolder.empty() && !report.cancelled) {
                m_checked[backupFolder] = report.ok();
                showBackups();
            }
            endTask();
        });
    m_strip->start(backupFolder.empty() ? tr("Verifying everything …") : tr("Checking the backup …"), token);
    showButtons();
}

void StorageScreen::askRestore() {
    const session::BackupEntry* backup = selected();
    if (!backup)
        return;
    RestoreDialog::ask(context(), *backup, RestoreDialog::Replaces::working, this,
                       [this](database::RestoreRequest request) { restore(std::move(request)); });
}

void StorageScreen::restore(database::RestoreRequest request) {
    m_restoring = true; // the screen cannot be left, because there is no database until the restore ends
    showButtons();
    m_panel->showLoading(tr("Restoring the backup. The current database is kept."));
    context().background().cancelAndWait();
    context().site().close();
    context().background().run(
        this,
        [request = std::move(request), options = context().site().options()](WorkToken&) {
            return database::Upkeep::restore(request, options);
        },
        [this](const core::Result<database::RestoreInfo>& result) { restored(result); });
}

void StorageScreen::restored(const core::Result<database::RestoreInfo>& result) {
    AppContext& app = context();
    if (!result) {
        const core::Error error = result.error();
        connect(
            &app, &AppContext::siteOpened, this,
            [this, error] {
                m_restoring = false;
                context().messages().error(tr("Nothing was restored. The current database is unchanged."),
                                           error);
                load();
                endTask();
            },
            Qt::SingleShotConnection);
        connect(&app, &AppContext::siteFailed, this, [this](const core::Error& why) {
            m_restoring = false;
            m_panel->showError(
                tr("The current database could not be opened again."), why, [this] { context().openSite(); },
                Tried::opening);
        });
        app.openSite();
        return;
    }
    m_restoring = false;
    const QString kept = QString::fromStdString(result->keptOldFile);
    emit taskEnded();
    app.logOut(); // destroys this screen
    app.openSite();
    app.messages().done(
        tr("The backup was restored. The previous database is kept as %1. Please log in again.").arg(kept));
}

} // namespace chiron::desktop
