// SPDX-License-Identifier: GPL-3.0-or-later
// P3's verification on the station screen: its task on a worker, its end, its record.
#include "core/fp_environment.h"
#include "database/access/access_table.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/file_folder.h"
#include "desktop/site/site_name.h"
#include "desktop/station/platform_card.h"
#include "desktop/station/station_screen.h"
#include "desktop/storage/task_strip.h"
#include "devices/driver_catalogue.h"

#include <QFileDialog>
#include <QPushButton>
#include <QSysInfo>

namespace chiron::desktop {

PlatformCard* StationScreen::platformCard() {
    m_platform = new PlatformCard(context().theme(), context().locale(), mayCheck());
    m_platform->setObjectName(QStringLiteral("station.platform"));
    connect(m_platform, &PlatformCard::checkAsked, this, &StationScreen::startVerification);
    connect(m_platform, &PlatformCard::recordAsked, this, &StationScreen::askRecord);
    return m_platform;
}

void StationScreen::startVerification() {
    if (!m_platform || !m_platform->button() || !m_platform->button()->isEnabled() || context().trialRuns())
        return; // a session's loop must not share the computer with it
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
            if (check) {
                m_platformSerial = QString::fromStdString(check->serialNumber);
                const devices::Driver& driver = devices::usualDriver(devices::MovedBy::scriptedOperator);
                note({"fingertip_platform", std::string(driver.id), core::buildId(), check->holds(),
                      check->serialNumber},
                     &m_platformChecked);
                m_platform->show(std::move(*check));
            } else if (check.error().code == core::ErrorCode::cancelled)
                m_platform->showStopped();
            else
                m_platform->showError(check.error());
            showButton();
            emit verificationEnded();
        });
    m_strip->start(tr("Verifying the fingertip platform."), m_token);
    showButton();
}

bool StationScreen::mayCheck() const {
    return database::scopeOf(database::Action::recordStationCheck, context().actor().kind(),
                             context().roles()) != database::Scope::none;
}

/// Stores a check in the audit trail as soon as its result is known, so that failed checks are kept as well.
void StationScreen::note(const database::StationCheck& check, CheckedAt* at) {
    *at = {QDateTime::currentDateTime(), 0, {}};
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor(), check](WorkToken&) {
            auto entry = database.write([&](database::WriteContext& writing) {
                return database::StationRepository(writing.connection(), actor).recordStationCheck(check);
            });
            return std::pair(std::move(entry), readSiteName(database, actor).value_or(QString()));
        },
        [this, at](const std::pair<core::Result<std::int64_t>, QString>& noted) {
            const auto& [entry, site] = noted;
            at->site = site;
            if (entry)
                at->entry = *entry;
            else
                context().messages().error(tr("The check could not be written to the audit trail."),
                                           entry.error());
            emit checkNoted();
        });
}

CheckCircumstances StationScreen::circumstances(const CheckedAt& at, const QString& device,
                                                const std::optional<QString>& serial) const {
    return {context().shownName(),
            at.when,
            QSysInfo::machineHostName(),
            device,
            serial,
            QString::fromStdString(core::buildId()),
            at.entry,
            at.site};
}

core::Result<void> StationScreen::writePlatformRecord(const QString& path) const {
    return m_platform->writeRecord(
        path, circumstances(m_platformChecked, tr("Simulated fingertip platform"), m_platformSerial));
}

core::Result<void> StationScreen::writeLoopRecord(const QString& path) const {
    if (!m_tested)
        return core::fail(core::ErrorCode::wrongUse, "the self-test was not run yet");
    return report::writeCheckPdf(
        path,
        loopRecord(*m_tested,
                   circumstances(m_loopChecked, tr("None: the loop alone, without a device"), std::nullopt),
                   context().locale()),
        report::lightTheme(context().locale()));
}

void StationScreen::askRecord() {
    saveRecord(tr("Fingertip platform.pdf"),
               [this](const QString& path) { return writePlatformRecord(path); });
}

void StationScreen::saveRecord(const QString& name, std::function<core::Result<void>(const QString&)> write) {
    auto* dialog = new QFileDialog(this, tr("Save the record"), QString(), tr("PDF documents (*.pdf)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("pdf"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("station_records"));
    dialog->selectFile(name);
    connect(dialog, &QFileDialog::fileSelected, this, [this, write = std::move(write)](const QString& path) {
        if (const auto written = write(path))
            context().messages().done(tr("The record was saved in %1.").arg(path));
        else
            context().messages().error(tr("The record could not be saved."), written.error());
    });
    dialog->open();
}

} // namespace chiron::desktop
