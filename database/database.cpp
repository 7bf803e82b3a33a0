// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/database.h"

#include "core/clock.h"
#include "database/accounts/account_rules.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"
#include "database/schema/migration_runner.h"
#include "database/writer_lock.h"

#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QUuid>
#include <sodium.h>

namespace chiron::database {
namespace {

core::Result<void> fillNew(Connection& connection, const DatabaseOptions& options) {
    auto done = connection.begin();
    CHIRON_TRY(done);
    const std::string uuid = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
    for (const auto& [key, value] : {std::pair<std::string, std::string>{"uuid", uuid},
                                     {"created_utc", core::utcNowIso8601()},
                                     {"demonstration", options.demonstration ? "1" : "0"}}) {
        auto inserted = Query::run(connection, "INSERT INTO meta (key, value) VALUES (?, ?)", {key, value});
        if (!inserted) {
            connection.rollback();
            return tl::unexpected(inserted.error());
        }
    }
    auto person = insertRow(connection, "person",
                            {{"id", Actor::kSimulatedPerson},
                             {"kind", std::string("simulated")},
                             {"name", std::string("simulated")},
                             {"name_key", std::string("simulated")},
                             {"display_name", std::string("simulated")},
                             {"roles", std::string()},
                             {"enabled", std::int64_t{1}},
                             {"created_utc", core::utcNowIso8601()}});
    if (!person) {
        connection.rollback();
        return tl::unexpected(person.error());
    }
    done = appendAudit(connection, Actor::maintenance(),
                       {"create", "person", Actor::kSimulatedPerson, *person, "{}"});
    if (!done) {
        connection.rollback();
        return done;
    }
    return connection.commit();
}

// Makes a complete new database in a file of another name.
core::Result<void> fillFile(const std::string& file, const SiteKey& key, const DatabaseOptions& options) {
    auto connection = Connection::create(file);
    CHIRON_TRY(connection);
    (*connection)->setSite(&key, options.clock.get());
    CHIRON_TRY(keepPrivate(file)); // SQLite gives the log beside it the same permissions
    CHIRON_TRY(MigrationRunner().migrate(**connection));
    auto done = fillNew(**connection, options);
    // The file is in WAL mode from the start: a rollback journal left by a kill would lock out readers.
    done = done ? (*connection)->execute("PRAGMA journal_mode=WAL") : done;
    CHIRON_TRY(done);
    const auto head = auditHead(**connection);
    CHIRON_TRY(head);
    return writeHeadFile(key, *head);
}

} // namespace

std::string siteFolderFor(const std::string& databaseFile, const DatabaseOptions& options) {
    return options.siteFolder.empty() ? databaseFile + ".site" : options.siteFolder;
}

Database::Database(std::string file, DatabaseOptions options)
    : m_file(std::move(file)), m_options(std::move(options)), m_siteFolder(siteFolderFor(m_file, m_options)) {
    if (!m_options.clock) {
        m_options.clock = std::make_shared<SystemBootClock>();
    }
}

Database::~Database() {
    m_writer.reset(); // before key and lock: its last drains still need both
}

core::Result<std::unique_ptr<Database>> Database::create(const std::string& file,
                                                         const DatabaseOptions& options) {
    std::unique_ptr<Database> database(new Database(file, options));
    auto lock = takeWriterLock(file);
    CHIRON_TRY(lock);
    database->m_lock = *std::move(lock);
    if (QFileInfo::exists(QString::fromStdString(file))) {
        return core::fail(core::ErrorCode::badInput, file + ": exists already; nothing was changed");
    }
    auto key = SiteKey::createOrLoad(database->m_siteFolder);
    CHIRON_TRY(key);
    database->m_siteKey = *std::move(key);
    const QString fresh = QString::fromStdString(file + ".new"); // a file with its final name is always
                                                                 // complete
    QFile::remove(fresh);
    auto done = fillFile(fresh.toStdString(), *database->m_siteKey, database->m_options);
    if (done && !QFile::rename(fresh, QString::fromStdString(file))) {
        done = core::fail(core::ErrorCode::storage, file + ": cannot be put in place");
    }
    done = done ? database->startWriter() : done;
    if (!done) {
        QFile::remove(fresh);
        return tl::unexpected(done.error());
    }
    return database;
}

core::Result<std::unique_ptr<Database>> Database::openForWriting(const std::string& file,
                                                                 const DatabaseOptions& options) {
    std::unique_ptr<Database> database(new Database(file, options));
    const MigrationRunner runner;
    auto present = runner.inspect(file);
    CHIRON_TRY(present);
    auto lock = takeWriterLock(file);
    CHIRON_TRY(lock);
    database->m_lock = *std::move(lock);
    auto key = SiteKey::load(database->m_siteFolder);
    CHIRON_TRY(key);
    database->m_siteKey = *std::move(key);
    if (present->version < runner.newest()) {
        auto connection = Connection::open(file, Connection::Mode::readWrite);
        CHIRON_TRY(connection);
        auto migrated = runner.migrate(**connection);
        CHIRON_TRY(migrated);
    }
    auto started = database->startWriter();
    CHIRON_TRY(started);
    return database;
}

core::Result<std::unique_ptr<Database>> Database::openReadOnly(const std::string& file,
                                                               const DatabaseOptions& options) {
    std::unique_ptr<Database> database(new Database(file, options));
    const MigrationRunner runner;
    auto present = runner.inspect(file);
    CHIRON_TRY(present);
    if (present->version < runner.newest()) {
        return core::fail(core::ErrorCode::storage, file + ": made by an older Chiron (schema " +
                                                        std::to_string(present->version) +
                                                        "); run migrate first");
    }
    auto read = database->readIdentity();
    CHIRON_TRY(read);
    return database;
}

core::Result<std::unique_ptr<Connection>> Database::openReader() const {
    auto connection = Connection::open(m_file, Connection::Mode::readOnly);
    if (connection) {
        (*connection)->setSite(m_siteKey.get(), m_options.clock.get());
    }
    return connection;
}

core::Result<void> Database::startWriter() {
    auto writer = WriterThread::start(m_file, *m_siteKey, *m_options.clock);
    CHIRON_TRY(writer);
    m_writer = *std::move(writer);
    return readIdentity();
}

core::Result<void> Database::readIdentity() {
    auto reader = openReader();
    CHIRON_TRY(reader);
    const auto version = selectInteger(**reader, "PRAGMA user_version");
    const auto uuid = selectText(**reader, "SELECT value FROM meta WHERE key = 'uuid'");
    const auto demonstration = selectText(**reader, "SELECT value FROM meta WHERE key = 'demonstration'");
    CHIRON_TRY(version);
    CHIRON_TRY(uuid);
    CHIRON_TRY(demonstration);
    m_schemaVersion = static_cast<int>(version->value_or(0));
    m_uuid = uuid->value_or("");
    m_demonstration = demonstration->value_or("0") == "1";
    return {};
}

} // namespace chiron::database
