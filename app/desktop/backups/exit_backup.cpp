// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/backups/exit_backup.h"

#include "desktop/frame/app_context.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/logo.h"
#include "session/backup_schedule.h"

#include <QApplication>
#include <QDialog>
#include <QEventLoop>
#include <QProgressBar>
#include <QTimer>

namespace chiron::desktop {

namespace {

constexpr int kShownAfter_ms = 500; // experience.md, Rules

/// The translation context of the texts.
struct ExitBackup {
    Q_DECLARE_TR_FUNCTIONS(ExitBackup)
};

/// Fills the dialog, which says what is happening; its button calls `leaveOut` for people who do not want to
/// wait.
void fillExitDialog(QDialog& dialog, const Theme& theme, const std::function<void()>& leaveOut) {
    dialog.setObjectName(QStringLiteral("exit_backup"));
    dialog.setWindowTitle(QStringLiteral("Chiron"));
    dialog.setMinimumWidth(theme.px(420));
    auto* column = new QVBoxLayout(&dialog);
    column->setContentsMargins(theme.px(24), theme.px(20), theme.px(24), theme.px(20));
    column->setSpacing(theme.px(12));
    column->addWidget(logo(theme, 48));
    column->addWidget(kit::label(theme, ExitBackup::tr("Making today's backup"), TextStyle::title));
    auto* words =
        kit::label(theme, ExitBackup::tr("Chiron closes by itself when the backup is made and checked."));
    column->addWidget(words);
    auto* bar = new QProgressBar;
    bar->setAccessibleName(ExitBackup::tr("Progress"));
    bar->setRange(0, 0);
    column->addWidget(bar);
    auto* without = kit::button(theme, ExitBackup::tr("Close without a backup"));
    without->setObjectName(QStringLiteral("exit_backup.leave_out"));
    column->addWidget(without, 0, Qt::AlignHCenter);
    QObject::connect(without, &QPushButton::clicked, &dialog, &QDialog::reject);
    QObject::connect(&dialog, &QDialog::rejected, &dialog, leaveOut);
}

} // namespace

void backUpAtExit(AppContext& context) {
    if (!context.site().isOpen() || !context.site().database().isWritable())
        return;
    const bool quits = QApplication::quitOnLastWindowClosed();
    QApplication::setQuitOnLastWindowClosed(false); // hiding the small window must not end the loop below
    QEventLoop loop;
    const auto token = context.background().run(
        &loop,
        [&database = context.site().database(), station = context.settings().backupFolder().toStdString()](
            WorkToken& working) { return session::backUpIfDue(database, station, &working.flag()).due; },
        [&loop](bool) { loop.quit(); });
    QDialog dialog;
    fillExitDialog(dialog, context.theme(), [token] { token->cancel(); });
    QTimer::singleShot(kShownAfter_ms, &dialog, &QDialog::show);
    loop.exec();
    // Hiding the dialog must not count as a cancel. The other connections of the dialog belong to the style.
    QObject::disconnect(&dialog, &QDialog::rejected, nullptr, nullptr);
    dialog.hide();
    QApplication::setQuitOnLastWindowClosed(quits);
}

} // namespace chiron::desktop
