// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clock.h"
#include "database/access/authorise.h"
#include "database/upkeep/backup_notes.h"
#include "database/upkeep/snapshot_folder.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <vector>

namespace chiron::database {
namespace {

// For the manifest, the erasures, and anybody else who writes there.
constexpr std::uint64_t kSpare_bytes = 16 << 20;

/// A scheduled backup of this site, according to its signed manifest.
struct OwnBackup {
    QString folder;
    std::int64_t number = 0;
};

/// Returns the prefix by which sites that share a folder recognise their own backups.
QString ownPrefix(const Database& database) {
    return QStringLiteral("chiron-auto-%1-").arg(QString::fromStdString(database.uuid()).left(8));
}

std::vector<OwnBackup> ownBackups(const QDir& place, const QString& prefix, const SiteKey& key) {
    std::vector<OwnBackup> own;
    for (const QString& name :
         place.entryList({prefix + QLatin1Char('*')}, QDir::Dirs | QDir::NoDotAndDotDot)) {
        const QString folder = place.filePath(name);
        const auto manifest = readSignedManifest(folder.toStdString(), key);
        // Otherwise it belongs to another site, or was made by hand.
        if (manifest && manifest->kind == "backup" && manifest->automaticNumber > 0) {
            own.push_back({folder, manifest->automaticNumber});
        }
    }
    std::sort(own.begin(), own.end(),
              [](const OwnBackup& a, const OwnBackup& b) { return a.number > b.number; });
    return own;
}

/// Removes what a killed program left half-written or half-removed. No other program of this site can be at
/// work, because we hold its lock.
void removeLeftovers(const QDir& place, const QString& prefix) {
    for (const char* ending : {"*.partial", "*.removing"}) {
        for (const QString& name :
             place.entryList({prefix + QLatin1String(ending)}, QDir::Dirs | QDir::NoDotAndDotDot)) {
            QDir(place.filePath(name)).removeRecursively();
        }
    }
}

/// Renames the backup first, so that a kill leaves nothing that looks like a backup.
bool removeBackup(const QString& folder) {
    const QString going = folder + QStringLiteral(".removing");
    return QDir().rename(folder, going) && QDir(going).removeRecursively();
}

QString newName(const QDir& place, const QString& prefix) {
    const QString base =
        place.filePath(prefix + QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss")));
    QString name = base;
    for (int i = 2; QFileInfo::exists(name); ++i) { // the clock was set back
        name = QStringLiteral("%1-%2").arg(base).arg(i);
    }
    return name;
}

core::Result<void> checkRoom(const Database& database, const QString& place) {
    std::error_code error;
    std::uint64_t needed = kSpare_bytes;
    for (const char* part : {"", "-wal"}) {
        const auto size = std::filesystem::file_size(database.file() + part, error);
        needed += error ? 0 : size;
    }
    const auto space = std::filesystem::space(place.toStdString(), error);
    if (error || space.available >= needed) {
        return {}; // if the file system does not report its space, the backup is tried
    }
    const auto megabytes = [](std::uint64_t bytes) {
        return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MB";
    };
    return core::fail(core::ErrorCode::storage, place.toStdString() + ": too little room, " +
                                                    megabytes(needed) + " needed, " +
                                                    megabytes(space.available) + " free");
}

core::Result<DailyBackup> make(Database& database, Connection& reader, const std::string& placeName, int keep,
                               const SiteKey& key, const std::atomic<bool>* cancel) {
    const QString name = QString::fromStdString(placeName);
    if (!QDir().mkpath(name) || !QFileInfo(name).isDir()) {
        return core::fail(core::ErrorCode::storage,
                          placeName + ": this folder is not there and cannot be made");
    }
    const QDir place(name);
    const QString prefix = ownPrefix(database);
    removeLeftovers(place, prefix);
    CHIRON_TRY(checkRoom(database, name));
    const std::vector<OwnBackup> before = ownBackups(place, prefix, key);
    const std::int64_t number = before.empty() ? 1 : before.front().number + 1;
    const QString folder = newName(place, prefix);
    auto made = writeSnapshotFolder(database, reader, folder.toStdString(), "backup", {}, cancel, number);
    CHIRON_TRY(made);
    // Checks what is on the disk and not what was written to it.
    if (const auto readBack = readManifest(made->folder, key, cancel); !readBack) {
        removeBackup(folder);
        return tl::unexpected(readBack.error());
    }
    DailyBackup done{*made, 0};
    // The new backup counts, too.
    for (std::size_t i = static_cast<std::size_t>(keep) - 1; i < before.size(); ++i) {
        done.removed += removeBackup(before[i].folder) ? 1 : 0; // one that cannot be removed now is tried
                                                                // again tomorrow
    }
    return done;
}

core::Result<void> note(Database& database, const Actor& actor, const core::Result<DailyBackup>& done) {
    return database.write([&](WriteContext& writing) -> core::Result<void> {
        auto standing = Upkeep::backupStanding(writing.connection(), actor);
        CHIRON_TRY(standing);
        standing->triedUtc = core::utcNowIso8601();
        standing->problem = done ? std::string() : done.error().message;
        if (done) {
            standing->goodUtc = standing->triedUtc;
            standing->goodFolder = done->made.folder;
            standing->goodBytes = done->made.bytes;
        }
        const auto noted = noteOutcome(writing.connection(), *standing);
        if (!noted || !done) {
            return noted;
        }
        return appendAudit(
            writing.connection(), actor,
            {"dailyBackup", "meta", 0, std::nullopt, "{\"blake2b\":\"" + done->made.blake2b + "\"}"});
    });
}

} // namespace

core::Result<DailyBackup> Upkeep::dailyBackup(Database& database, const Actor& actor,
                                              const std::string& place, int keep,
                                              const std::atomic<bool>* cancel) {
    auto reader = database.openReader();
    CHIRON_TRY(reader);
    CHIRON_TRY(authorise(**reader, actor, Action::dailyBackup));
    if (keep < 1 || keep > kMostBackupsKept || !database.isWritable()) {
        return core::fail(core::ErrorCode::wrongUse, "a daily backup keeps 1 to " +
                                                         std::to_string(kMostBackupsKept) +
                                                         ", of a database that is open for writing");
    }
    const auto key = SiteKey::load(database.siteFolder());
    auto done = key ? make(database, **reader, place, keep, **key, cancel)
                    : core::Result<DailyBackup>(tl::unexpected(key.error()));
    if (!done && done.error().code == core::ErrorCode::cancelled) {
        return done; // another task needed the machine: not a failure
    }
    const auto noted = note(database, actor, done);
    return noted || !done ? done : core::Result<DailyBackup>(tl::unexpected(noted.error()));
}

} // namespace chiron::database
