// SPDX-License-Identifier: GPL-3.0-or-later
// P3's verification on the station screen: a worker's task, its end, its record.
#include "desktop/frame/app_context.h"
#include "desktop/station/platform_card.h"
#include "desktop/station/station_screen.h"
#include "desktop/storage/task_strip.h"

#include <QDateTime>
#include <QFileDialog>
#include <QPushButton>
#include <QSysInfo>

namespace chiron::desktop {

PlatformCard* StationScreen::platformCard() {
    m_platform = new PlatformCard(context().theme(), context().locale(), context().has(database::Role::admin));
    m_platform->setObjectName(QStringLiteral("station.platform"));
    connect(m_platform, &PlatformCard::checkAsked, this, &StationScreen::startVerification);
    connect(m_platform, &PlatformCard::recordAsked, this, &StationScreen::askRecord);
    return m_platform;
}

void StationScreen::startVerification() {
    if (!m_platform || !m_platform->button() || !m_platform->button()->isEnabled() || context().trialRuns())
        return; // a session's loop must not share the machine with it
    PlatformCheckLength length;
    if (const QVariant poses = place().parameters.value(QStringLiteral("verify_poses")); poses.isValid()) {
        length.poses = poses.toInt();
        length.degrade = false;
    }
    m_token = context().background().run(
        this, [length](WorkToken& token) { return runPlatformCheck(length, token); },
        [this](core::Result<PlatformCheck> check) {
            m_strip->stop();
            m_token.reset();
            if (check)
                m_platform->show(std::move(*check));
            else if (check.error().code == core::ErrorCode::cancelled)
                m_platform->showStopped();
            else
                m_platform->showError(check.error());
            showButton();
            emit verificationEnded();
        });
    m_strip->start(tr("Verifying the fingertip platform."), m_token);
    showButton();
}

void StationScreen::askRecord() {
    auto* dialog = new QFileDialog(this, tr("Save the record"), tr("Fingertip platform.pdf"), tr("PDF documents (*.pdf)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("pdf"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        const QString when = tr("%1, on %2").arg(context().locale().toString(QDateTime::currentDateTime(), QLocale::ShortFormat), QSysInfo::machineHostName());
        if (const auto written = m_platform->writeRecord(path, when))
            context().messages().done(tr("The record was saved in %1.").arg(path));
        else
            context().messages().error(tr("The record could not be saved."), written.error());
    });
    dialog->open();
}

} // namespace chiron::desktop
