// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/schema/migration_runner.h"

#include "database/interruptible.h"
#include "database/query.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QtEndian>
#include <fcntl.h>
#include <unistd.h>

// Resources of a static library are not registered automatically; the macro must stand outside any namespace.
static void registerMigrations() {
    Q_INIT_RESOURCE(migrations);
}

namespace chiron::database {
namespace {

core::Result<SchemaVersion> headerOf(const std::string& name) {
    QFile file(QString::fromStdString(name));
    if (!file.exists()) {
        return core::fail(core::ErrorCode::notFound, name + ": there is no such database");
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return core::fail(core::ErrorCode::storage, name + ": cannot be read");
    }
    const QByteArray header = file.read(100);
    if (header.size() < 100 || !header.startsWith(QByteArray("SQLite format 3\0", 16))) {
        return core::fail(core::ErrorCode::storage, name + ": not a database (no SQLite header)");
    }
    return SchemaVersion{qFromBigEndian<qint32>(header.constData() + 68),
                         qFromBigEndian<qint32>(header.constData() + 60)};
}

core::Result<SchemaVersion> pragmasOf(const std::string& name) {
    auto connection = Connection::open(name, Connection::Mode::readOnly);
    CHIRON_TRY(connection);
    const auto id = selectInteger(**connection, "PRAGMA application_id");
    const auto version = selectInteger(**connection, "PRAGMA user_version");
    const auto tables = selectInteger(**connection, "SELECT count(*) FROM sqlite_schema");
    CHIRON_TRY(id);
    CHIRON_TRY(version);
    CHIRON_TRY(tables);
    return SchemaVersion{static_cast<int>(id->value_or(0)), static_cast<int>(version->value_or(0))};
}

core::Result<void> judge(const std::string& file, const SchemaVersion& found, int newest) {
    if (found.applicationId != kApplicationId) {
        return core::fail(core::ErrorCode::storage, file +
                                                        ": a database of another program (application id " +
                                                        std::to_string(found.applicationId) + ", expected " +
                                                        std::to_string(kApplicationId) + "); left unchanged");
    }
    if (found.version > newest || found.version < 1) {
        return core::fail(core::ErrorCode::storage,
                          file + ": made by a newer Chiron (schema " + std::to_string(found.version) +
                              ", this program knows 1 to " + std::to_string(newest) + "); left unchanged");
    }
    return {};
}

} // namespace

std::vector<Migration> builtInMigrations() {
    registerMigrations();
    std::vector<Migration> migrations;
    const QDir folder(QStringLiteral(":/database/migrations"));
    for (const QString& name : folder.entryList({QStringLiteral("*.sql")}, QDir::Files, QDir::Name)) {
        QFile file(folder.filePath(name));
        if (file.open(QIODevice::ReadOnly)) {
            migrations.push_back({name.left(4).toInt(), name.toStdString(), file.readAll().toStdString()});
        }
    }
    return migrations;
}

core::Result<SchemaVersion> MigrationRunner::inspect(const std::string& file) const {
    // The bytes are checked first, so that a foreign or newer file is refused before SQLite touches anything
    // beside it.
    auto header = headerOf(file);
    CHIRON_TRY(header);
    auto judged = judge(file, *header, newest());
    CHIRON_TRY(judged);
    auto present = pragmasOf(file);
    CHIRON_TRY(present);
    judged = judge(file, *present, newest());
    CHIRON_TRY(judged);
    return present;
}

core::Result<std::string> MigrationRunner::migrate(Connection& connection) const {
    const auto version = selectInteger(connection, "PRAGMA user_version");
    CHIRON_TRY(version);
    const int present = static_cast<int>(version->value_or(0));
    std::string copy;
    if (present > 0 && present < newest()) {
        const std::string base = connection.file() + ".before-v" + std::to_string(newest());
        copy = base;
        for (int i = 2; QFileInfo::exists(QString::fromStdString(copy)); ++i) {
            copy = base + "-" + std::to_string(i); // an earlier attempt's copy is never overwritten
        }
        auto copied = copyDatabase(connection, copy);
        CHIRON_TRY(copied);
    }
    for (const Migration& migration : m_migrations) {
        if (migration.version <= present) {
            continue;
        }
        auto done = step(connection, migration);
        CHIRON_TRY(done);
    }
    return copy;
}

core::Result<void> MigrationRunner::step(Connection& connection, const Migration& migration) const {
    auto done = connection.begin();
    if (done) {
        done = connection.execute(migration.sql);
    }
    if (done) {
        done = connection.execute("PRAGMA application_id=" + std::to_string(kApplicationId) +
                                  "; PRAGMA user_version=" + std::to_string(migration.version) + ";");
    }
    if (done && beforeCommit) {
        beforeCommit();
    }
    if (done) {
        return connection.commit();
    }
    connection.rollback();
    return tl::unexpected(core::Error{done.error().code, migration.name + ": " + done.error().message});
}

core::Result<void> keepPrivate(const std::string& file) {
    return QFile::setPermissions(QString::fromStdString(file), QFile::ReadOwner | QFile::WriteOwner)
               ? core::Result<void>()
               : core::fail(core::ErrorCode::storage, file + ": cannot be kept from others (permissions)");
}

core::Result<void> flushToDisk(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool flushed = descriptor >= 0 && ::fsync(descriptor) == 0;
    if (descriptor >= 0) {
        ::close(descriptor);
    }
    return flushed ? core::Result<void>()
                   : core::fail(core::ErrorCode::storage, path + ": cannot be flushed to the disk");
}

core::Result<void> copyDatabase(Connection& from, const std::string& toFile,
                                const std::atomic<bool>* cancel) {
    const QString target = QString::fromStdString(toFile);
    if (QFileInfo::exists(target)) {
        return core::fail(core::ErrorCode::badInput, toFile + ": exists already; a copy never overwrites");
    }
    const std::string partial = toFile + ".partial";
    QFile::remove(QString::fromStdString(partial)); // left by a killed copy
    // VACUUM INTO only reads `from`, but query_only treats it as writing (the file itself may be opened
    // read-only).
    (void)from.execute("PRAGMA query_only=OFF");
    auto copied = Query::run(from, "VACUUM INTO ?", {partial});
    if (!from.isWritable()) {
        (void)from.execute("PRAGMA query_only=ON");
    }
    core::Result<void> done;
    if (!copied) {
        done = tl::unexpected(copied.error());
    } else if (done = keepPrivate(partial); done && (done = flushToDisk(partial))) {
        auto connection = Connection::open(partial, Connection::Mode::readOnly);
        const auto interruptible =
            connection ? std::make_unique<Interruptible>(**connection, cancel) : nullptr;
        const auto words = connection ? selectText(**connection, "PRAGMA integrity_check(1)")
                                      : tl::unexpected(connection.error());
        if (!words || words->value_or("") != "ok") {
            done = core::fail(core::ErrorCode::storage, toFile + ": the copy does not pass SQLite's check");
        }
    }
    if (done && !QFile::rename(QString::fromStdString(partial), target)) {
        done = core::fail(core::ErrorCode::storage, toFile + ": the copy cannot be put in place");
    }
    if (!done) {
        QFile::remove(QString::fromStdString(partial));
        return done;
    }
    return flushToDisk(QFileInfo(target).absolutePath().toStdString());
}

} // namespace chiron::database
