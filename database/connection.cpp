// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/connection.h"

#include "database/query.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSqlDatabase>
#include <QSqlDriver>
#include <QSqlError>
#include <atomic>
#include <sqlite3.h>

namespace chiron::database {
namespace {

std::string uniqueName() {
    // Qt's registry of connections is global, so the names must differ.
    static std::atomic<unsigned long long> counter{0};
    return "chiron-" + std::to_string(++counter);
}

sqlite3* handleOf(const QSqlDatabase& database) {
    const QVariant handle = database.driver()->handle();
    return handle.isValid() && qstrcmp(handle.typeName(), "sqlite3*") == 0
               ? *static_cast<sqlite3* const*>(handle.constData())
               : nullptr;
}

} // namespace

Connection::Connection(std::string file, Mode mode)
    : m_file(std::move(file)), m_mode(mode), m_name(uniqueName()) {}

Connection::~Connection() {
    m_handle = nullptr;
    m_database.reset();
    QSqlDatabase::removeDatabase(QString::fromStdString(m_name));
}

core::Result<std::unique_ptr<Connection>> Connection::open(const std::string& file, Mode mode) {
    if (!QFileInfo::exists(QString::fromStdString(file))) {
        return core::fail(core::ErrorCode::notFound, file + ": there is no such database");
    }
    std::unique_ptr<Connection> connection(new Connection(file, mode));
    const bool reading = mode == Mode::readOnly;
    auto opened = connection->openQt(reading ? "QSQLITE_OPEN_READONLY;QSQLITE_BUSY_TIMEOUT=2000"
                                             : "QSQLITE_BUSY_TIMEOUT=2000");
    if (opened) {
        opened = connection->configure(!reading);
    }
    CHIRON_TRY(opened);
    return connection;
}

core::Result<std::unique_ptr<Connection>> Connection::create(const std::string& file) {
    std::unique_ptr<Connection> connection(new Connection(file, Mode::readWrite));
    auto opened = connection->openQt("QSQLITE_BUSY_TIMEOUT=2000");
    if (opened) {
        opened = connection->configure(false);
    }
    CHIRON_TRY(opened);
    return connection;
}

core::Result<void> Connection::openQt(const std::string& connectOptions) {
    if (QCoreApplication::instance() == nullptr) {
        return core::fail(core::ErrorCode::wrongUse, "a database needs a QCoreApplication (driver plugin)");
    }
    m_database = std::make_unique<QSqlDatabase>(
        QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QString::fromStdString(m_name)));
    m_database->setDatabaseName(QString::fromStdString(m_file));
    m_database->setConnectOptions(QString::fromStdString(connectOptions));
    if (!m_database->open()) {
        return core::fail(core::ErrorCode::storage, m_file + ": cannot be opened (" +
                                                        m_database->lastError().text().toStdString() + ")");
    }
    m_handle = handleOf(*m_database);
    if (m_handle == nullptr) {
        return core::fail(core::ErrorCode::storage, "Qt's SQLite driver gives no handle");
    }
    sqlite3_extended_result_codes(m_handle, 1);
    return {};
}

core::Result<void> Connection::configure(bool useWal) {
    // A schema from a damaged or foreign file must not run code or be trusted, and damaged cells are detected
    // when they are read.
    auto done = execute("PRAGMA foreign_keys=ON; PRAGMA trusted_schema=OFF; PRAGMA cell_size_check=ON;"
                        "PRAGMA synchronous=FULL;");
    if (done) {
        done = execute(isWritable() ? "PRAGMA secure_delete=ON;" : "PRAGMA query_only=ON;");
    }
    if (!done || !useWal) {
        return done;
    }
    const auto mode = selectText(*this, "PRAGMA journal_mode=WAL");
    CHIRON_TRY(mode);
    if (*mode != "wal") {
        return core::fail(core::ErrorCode::storage,
                          m_file + ": the file system does not allow write-ahead logging");
    }
    return {};
}

core::Result<void> Connection::execute(const std::string& sql) {
    char* words = nullptr;
    const int code = sqlite3_exec(m_handle, sql.c_str(), nullptr, nullptr, &words);
    if (code == SQLITE_OK) {
        return {};
    }
    const std::string text = words != nullptr ? words : "no words";
    sqlite3_free(words);
    return tl::unexpected(storageError(m_file, sql.substr(0, 80), code, text));
}

core::Result<void> Connection::commit() {
    auto done = execute("COMMIT");
    if (!done) {
        rollback();
    }
    return done;
}

void Connection::rollback() noexcept {
    if (inTransaction()) {
        sqlite3_exec(m_handle, "ROLLBACK", nullptr, nullptr, nullptr);
    }
}

bool Connection::inTransaction() const noexcept {
    return m_handle != nullptr && sqlite3_get_autocommit(m_handle) == 0;
}

} // namespace chiron::database
