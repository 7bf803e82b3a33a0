// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clock.h"
#include "database/access/authorise.h"
#include "database/integrity/snapshot_check.h"
#include "database/interruptible.h"
#include "database/privacy/erasure.h"
#include "database/schema/migration_runner.h"
#include "database/upkeep/snapshot_folder.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace chiron::database {
namespace {

// The folder contains people's names and results, so only the owner may access it, whatever the umask.
constexpr QFile::Permissions kOwnerAlone = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner;

std::string firstOf(const VerifyReport& report) {
    const Finding& finding = report.findings.front();
    return finding.kind + " " + finding.table + " " + finding.row + ": " + finding.detail;
}

core::Result<void> writeErasures(Connection& reader, const std::string& siteFolder, const std::string& file) {
    auto erasures = readErasureList(erasureListFile(siteFolder));
    const auto stored = storedErasures(reader);
    CHIRON_TRY(erasures);
    CHIRON_TRY(stored);
    for (const Erasure& erasure : *stored) {
        putErasure(*erasures, erasure);
    }
    return saveErasureList(file, *erasures);
}

// Does everything except renaming the folder, which is discarded if this fails.
core::Result<SnapshotInfo> fill(Database& database, Connection& reader, const std::string& folder,
                                const std::string& kind, const SiteKey& key, const SnapshotExtra& extra,
                                const std::atomic<bool>* cancel, std::int64_t automaticNumber) {
    const Interruptible interruptible(reader, cancel);
    const std::string copy = folder + "/" + kSnapshotFile;
    auto done = copyDatabase(reader, copy, cancel);
    done = done ? writeErasures(reader, database.siteFolder(), folder + "/" + kErasuresFile) : done;
    CHIRON_TRY(done);
    auto snapshot = Connection::open(copy, Connection::Mode::readOnly);
    CHIRON_TRY(snapshot);
    auto head = auditHead(**snapshot);
    CHIRON_TRY(head);
    if (const VerifyReport report = verifySnapshot(
            copy, &key, *head, {}, [cancel](std::uint64_t, std::uint64_t) { return !isSet(cancel); });
        !report.ok() && !report.cancelled) {
        return core::fail(core::ErrorCode::doesNotHold,
                          "the copy does not verify, nothing was kept: " + firstOf(report));
    }
    std::vector<std::string> files{kSnapshotFile, kErasuresFile};
    if (extra) {
        auto more = extra(**snapshot, folder);
        CHIRON_TRY(more);
        files.insert(files.end(), more->begin(), more->end());
    }
    snapshot->reset();
    Manifest manifest{kind, core::utcNowIso8601(), database.schemaVersion(), *head, {}, automaticNumber};
    for (const std::string& name : files) {
        const auto digest = fileDigest(folder + "/" + name, cancel);
        CHIRON_TRY(digest);
        manifest.files[name] = *digest;
    }
    CHIRON_TRY(writeManifest(folder, manifest, key));
    return SnapshotInfo{folder,
                        kSnapshotFile,
                        manifest.files[kSnapshotFile],
                        head->count,
                        head->hash,
                        static_cast<std::uint64_t>(QFileInfo(QString::fromStdString(copy)).size())};
}

} // namespace

core::Result<SnapshotInfo> writeSnapshotFolder(Database& database, Connection& reader,
                                               const std::string& folder, const std::string& kind,
                                               const SnapshotExtra& extra, const std::atomic<bool>* cancel,
                                               std::int64_t automaticNumber) {
    const auto key = SiteKey::load(database.siteFolder());
    CHIRON_TRY(key);
    const QString target = QString::fromStdString(folder);
    if (QFileInfo::exists(target)) {
        return core::fail(core::ErrorCode::badInput, folder + ": exists already; a new folder is needed");
    }
    const QString partial = target + QStringLiteral(".partial");
    QDir(partial).removeRecursively(); // left by a killed backup
    if (!QDir().mkpath(partial) || !QFile::setPermissions(partial, kOwnerAlone)) {
        return core::fail(core::ErrorCode::storage, folder + ": cannot be created");
    }
    auto info = fill(database, reader, partial.toStdString(), kind, **key, extra, cancel, automaticNumber);
    if (isSet(cancel)) { // whichever error it stopped with
        info = core::fail(core::ErrorCode::cancelled, folder + ": stopped, nothing was kept");
    }
    if (info && !QDir().rename(partial, target)) {
        info = core::fail(core::ErrorCode::storage, folder + ": cannot be put in place");
    }
    if (!info) {
        QDir(partial).removeRecursively();
        return info;
    }
    info->folder = folder;
    const auto flushed = flushToDisk(QFileInfo(target).absolutePath().toStdString());
    CHIRON_TRY(flushed);
    return info;
}

core::Result<SnapshotInfo> Upkeep::backup(Database& database, const Actor& actor, const std::string& folder,
                                          const std::atomic<bool>* cancel) {
    auto reader = database.openReader();
    CHIRON_TRY(reader);
    CHIRON_TRY(authorise(**reader, actor, Action::backup));
    const auto info = writeSnapshotFolder(database, **reader, folder, "backup", {}, cancel);
    if (!info || !database.isWritable()) {
        return info;
    }
    const auto audited = database.write([&](WriteContext& writing) {
        return appendAudit(writing.connection(), actor,
                           {"backup", "meta", 0, std::nullopt, "{\"blake2b\":\"" + info->blake2b + "\"}"});
    });
    CHIRON_TRY(audited);
    return info;
}

} // namespace chiron::database
