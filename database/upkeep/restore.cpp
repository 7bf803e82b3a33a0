// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/privacy/erasure.h"
#include "database/schema/migration_runner.h"
#include "database/upkeep/manifest.h"
#include "database/upkeep/restorable.h"
#include "database/upkeep/restore_rights.h"
#include "database/upkeep/upkeep.h"
#include "database/writer_lock.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <filesystem>

namespace chiron::database {
namespace {

// A site folder that a restore makes on a machine without one. It contains the key, and the erasures made
// since the backup if the key's folder lists them. A refused restore removes it again.
class NewSiteFolder {
public:
    NewSiteFolder() = default;
    NewSiteFolder(const NewSiteFolder&) = delete;
    NewSiteFolder& operator=(const NewSiteFolder&) = delete;
    ~NewSiteFolder() {
        for (const QString& file : m_files) {
            QFile::remove(file);
        }
        if (m_madeFolder) {
            QDir().rmdir(m_folder); // remains if it contains anything else
        }
    }

    core::Result<void> fill(const std::string& siteFolder, const std::string& keyFile) {
        m_folder = QString::fromStdString(siteFolder);
        const QString target = m_folder + QStringLiteral("/site.key");
        if (QFileInfo::exists(target) || keyFile.empty()) {
            return {};
        }
        const std::string list = QFileInfo(QString::fromStdString(keyFile)).absolutePath().toStdString();
        const QString erasures = QString::fromStdString(erasureListFile(list));
        const QString ownErasures = QString::fromStdString(erasureListFile(siteFolder));
        m_madeFolder = !QFileInfo::exists(m_folder);
        const bool copied =
            QDir().mkpath(m_folder) &&
            QFile::setPermissions(m_folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner) &&
            copy(QString::fromStdString(keyFile), target) &&
            (!QFileInfo::exists(erasures) || QFileInfo::exists(ownErasures) || copy(erasures, ownErasures));
        return copied ? core::Result<void>()
                      : core::fail(core::ErrorCode::storage,
                                   keyFile + ": the site key cannot be copied to " + siteFolder);
    }
    void keep() {
        m_files.clear();
        m_madeFolder = false;
    }

private:
    bool copy(const QString& from, const QString& to) {
        if (!QFile::copy(from, to)) {
            return false;
        }
        m_files << to;
        return QFile::setPermissions(to, QFile::ReadOwner | QFile::WriteOwner);
    }

    QString m_folder;
    QStringList m_files;
    bool m_madeFolder = false;
};

std::string freeName(const std::string& base) {
    std::string name = base;
    for (int i = 2; QFileInfo::exists(QString::fromStdString(name)); ++i) {
        name = base + "-" + std::to_string(i);
    }
    return name;
}

// Links the old file under its new name before the copy replaces it in one step, so that at every moment one
// of the two is in place.
core::Result<std::string> swapIn(const std::string& copy, const std::string& target) {
    namespace fs = std::filesystem;
    std::error_code error;
    std::string kept;
    if (fs::exists(target, error)) {
        const bool empty = fs::file_size(target, error) == 0; // SQLite would begin a new database in an empty
                                                              // file
        auto old = empty ? core::fail(core::ErrorCode::storage, target + ": empty")
                         : Connection::open(target, Connection::Mode::readWrite);
        if (old) {
            (void)(*old)->execute(
                "PRAGMA wal_checkpoint(TRUNCATE)"); // its log goes into the file, if that is still possible
            old->reset();
        }
        kept = freeName(target + ".before-restore");
        fs::create_hard_link(target, kept, error);
        if (error) {
            fs::copy_file(target, kept, error);
        }
        if (error) {
            return core::fail(core::ErrorCode::storage,
                              kept + ": the old file cannot be kept aside; nothing was changed");
        }
        if (fs::exists(target + "-wal", error)) {
            fs::rename(target + "-wal", kept + "-wal",
                       error); // otherwise SQLite would replay the old log into the new file
        }
        fs::remove(target + "-shm", error);
    }
    for (const char* suffix : {"-wal", "-shm"}) {
        fs::remove(copy + suffix, error); // empty; left by the readers that verified it
    }
    fs::rename(copy, target, error);
    if (error) {
        return core::fail(core::ErrorCode::storage,
                          target + ": the restored file cannot be put in place; the old one is " + kept);
    }
    auto flushed = flushToDisk(QFileInfo(QString::fromStdString(target)).absolutePath().toStdString());
    CHIRON_TRY(flushed);
    return kept;
}

// Returns the head of a file's audit chain.
core::Result<AuditHead> headOf(const std::string& file) {
    auto opened = Connection::open(file, Connection::Mode::readOnly);
    CHIRON_TRY(opened);
    return auditHead(**opened);
}

void removeWithItsLog(const std::string& file) {
    std::error_code error;
    for (const char* suffix : {"", "-wal", "-shm"})
        std::filesystem::remove(file + suffix, error);
}

} // namespace

core::Result<RestoreInfo> Upkeep::restore(const RestoreRequest& request, const DatabaseOptions& given) {
    DatabaseOptions options = given;
    options.siteFolder = siteFolderFor(request.targetFile, given);
    NewSiteFolder made;
    CHIRON_TRY(made.fill(options.siteFolder, request.siteKeyFile));
    const auto key = SiteKey::load(options.siteFolder);
    CHIRON_TRY(key);
    const auto lock = takeWriterLock(request.targetFile);
    CHIRON_TRY(lock);
    CHIRON_TRY(presentAdministratorAgrees(request, options));
    const auto manifest = readManifest(request.backupFolder, **key);
    CHIRON_TRY(manifest);
    const std::string copy = request.targetFile + ".restoring";
    const QString copyName = QString::fromStdString(copy);
    removeWithItsLog(copy); // left by a killed restore
    if (!QFile::copy(QString::fromStdString(request.backupFolder + "/" + kSnapshotFile), copyName)) {
        removeWithItsLog(copy);
        return core::fail(core::ErrorCode::storage, copy + ": the backup cannot be copied (disk full?)");
    }
    QFile::setPermissions(copyName, QFile::ReadOwner | QFile::WriteOwner);
    const auto applied = makeRestorable(copy, request, options, **key, manifest->head);
    // Read while nothing has changed yet: a failure after the swap would leave the job half done.
    const auto head = applied ? headOf(copy) : tl::unexpected(applied.error());
    const auto kept =
        head ? swapIn(copy, request.targetFile) : core::Result<std::string>(tl::unexpected(head.error()));
    if (!kept) {
        removeWithItsLog(copy);
        return tl::unexpected(kept.error());
    }
    made.keep();
    // The site's head follows the chain of the file that is now in place.
    const auto written = writeHeadFile(**key, *head);
    CHIRON_TRY(written);
    return RestoreInfo{request.targetFile, *kept, *applied};
}

} // namespace chiron::database
