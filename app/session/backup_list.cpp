// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/backup_list.h"

#include "catalogue/whole_file.h"
#include "database/audit/site_key.h"
#include "database/integrity/snapshot_check.h"
#include "database/schema/migration_runner.h"
#include "database/upkeep/manifest.h"
#include "session/integrity_check.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace chiron::session {

namespace {

database::VerifyReport broken(const std::string& folder, const core::Error& error) {
    database::VerifyReport report;
    report.findings.push_back({"file", "", folder, error.message});
    return report;
}

} // namespace

std::vector<BackupEntry> listBackups(const std::string& folder) {
    std::vector<BackupEntry> backups;
    const QDir directory(QString::fromStdString(folder));
    for (const QFileInfo& entry : directory.entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const auto text = catalogue::readWholeFile(entry.filePath() + QStringLiteral("/manifest.json"),
                                                   database::kLargestManifest_bytes);
        const bool halfWay = entry.fileName().endsWith(QLatin1String(".partial")) ||
                             entry.fileName().endsWith(QLatin1String(".removing"));
        if (halfWay || !text)
            continue;
        const QJsonObject manifest = QJsonDocument::fromJson(*text).object();
        if (manifest.value(QLatin1String("kind")).toString() != QLatin1String("backup"))
            continue;
        const QFileInfo copy(entry.filePath() + QLatin1Char('/') + QLatin1String(database::kSnapshotFile));
        backups.push_back({entry.absoluteFilePath().toStdString(),
                           manifest.value(QLatin1String("created_utc")).toString().toStdString(),
                           static_cast<std::uint64_t>(copy.size()),
                           manifest.value(QLatin1String("automatic_number")).toInteger() > 0});
    }
    std::sort(backups.begin(), backups.end(),
              [](const auto& a, const auto& b) { return a.createdUtc > b.createdUtc; });
    return backups;
}

database::VerifyReport verifyBackup(const std::string& folder, const std::string& databaseFile,
                                    const database::DatabaseOptions& options,
                                    const database::VerifyWatch& watch) {
    const auto key = database::SiteKey::load(database::siteFolderFor(databaseFile, options));
    if (!key)
        return broken(folder, key.error());
    const auto manifest = database::readManifest(folder, **key);
    if (!manifest)
        return broken(folder, manifest.error());
    return database::verifySnapshot(folder + "/" + database::kSnapshotFile, key->get(), manifest->head,
                                    checkScores, watch);
}

core::Result<void> looksWhole(const std::string& folder, const std::string& databaseFile,
                              const database::DatabaseOptions& options) {
    const auto key = database::SiteKey::load(database::siteFolderFor(databaseFile, options));
    CHIRON_TRY(key);
    const auto manifest = database::readManifest(folder, **key);
    CHIRON_TRY(manifest);
    const auto present = database::MigrationRunner().inspect(folder + "/" + database::kSnapshotFile);
    CHIRON_TRY(present);
    return {};
}

std::string defaultBackupFolder(const std::string& databaseFile) {
    return QFileInfo(QString::fromStdString(databaseFile))
        .absoluteDir()
        .filePath(QStringLiteral("backups"))
        .toStdString();
}

} // namespace chiron::session
