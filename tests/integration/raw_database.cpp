// SPDX-License-Identifier: GPL-3.0-or-later
#include "raw_database.h"

#include <QCryptographicHash>
#include <cstring>
#include <sqlite3.h>

namespace {

/// A prepared statement; not copied.
class Statement {
public:
    Statement(sqlite3* handle, const QString& sql) {
        m_good = sqlite3_prepare_v2(handle, sql.toUtf8().constData(), -1, &m_statement, nullptr) == SQLITE_OK;
    }
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;
    ~Statement() { sqlite3_finalize(m_statement); }
    int step() { return m_good ? sqlite3_step(m_statement) : SQLITE_ERROR; }
    sqlite3_stmt* get() const { return m_statement; }

private:
    sqlite3_stmt* m_statement = nullptr;
    bool m_good = false;
};

/// The value as bytes: integers and reals as their eight, texts and blobs as they are.
QByteArray bitsOf(sqlite3_stmt* row, int column) {
    switch (sqlite3_column_type(row, column)) {
    case SQLITE_INTEGER: {
        const sqlite3_int64 value = sqlite3_column_int64(row, column);
        return QByteArray(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    case SQLITE_FLOAT: {
        const double value = sqlite3_column_double(row, column);
        return QByteArray(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    case SQLITE_TEXT:
    case SQLITE_BLOB: {
        const void* bytes = sqlite3_column_blob(row, column);
        return QByteArray(static_cast<const char*>(bytes), sqlite3_column_bytes(row, column));
    }
    default:
        return {};
    }
}

void bind(sqlite3_stmt* statement, int index, int type, const QByteArray& bits) {
    sqlite3_int64 integer = 0;
    double real = 0.0;
    switch (type) {
    case SQLITE_INTEGER:
        std::memcpy(&integer, bits.constData(), sizeof(integer));
        sqlite3_bind_int64(statement, index, integer);
        break;
    case SQLITE_FLOAT:
        std::memcpy(&real, bits.constData(), sizeof(real));
        sqlite3_bind_double(statement, index, real);
        break;
    case SQLITE_TEXT:
        sqlite3_bind_text(statement, index, bits.constData(), int(bits.size()), SQLITE_TRANSIENT);
        break;
    default:
        sqlite3_bind_blob(statement, index, bits.constData(), int(bits.size()), SQLITE_TRANSIENT);
        break;
    }
}

} // namespace

std::unique_ptr<RawDatabase> RawDatabase::open(const QString& file, Mode mode) {
    std::unique_ptr<RawDatabase> database(new RawDatabase);
    const int flags = mode == Mode::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE;
    if (sqlite3_open_v2(file.toUtf8().constData(), &database->m_handle, flags, nullptr) != SQLITE_OK)
        return nullptr;
    return database;
}

RawDatabase::~RawDatabase() {
    sqlite3_close(m_handle);
}

QStringList RawDatabase::tables() {
    QStringList names;
    Statement query(m_handle, "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name");
    while (query.step() == SQLITE_ROW)
        names << QString::fromUtf8(reinterpret_cast<const char*>(sqlite3_column_text(query.get(), 0)));
    return names;
}

std::optional<QByteArray> RawDatabase::contentOf(const QString& table) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    Statement query(m_handle, "SELECT rowid, * FROM " + table + " NOT INDEXED ORDER BY rowid");
    int step = query.step();
    for (; step == SQLITE_ROW; step = query.step()) {
        for (int i = 0; i < sqlite3_column_count(query.get()); ++i) {
            const QByteArray bits = bitsOf(query.get(), i);
            const qint64 head[] = {sqlite3_column_type(query.get(), i), bits.size()};
            hash.addData(QByteArray(reinterpret_cast<const char*>(head), sizeof(head)));
            hash.addData(bits);
        }
    }
    return step == SQLITE_DONE ? std::optional(hash.result()) : std::nullopt;
}

bool RawDatabase::isSound() {
    Statement query(m_handle, "PRAGMA integrity_check(1)");
    return query.step() == SQLITE_ROW &&
           std::strcmp(reinterpret_cast<const char*>(sqlite3_column_text(query.get(), 0)), "ok") == 0;
}

bool RawDatabase::execute(const char* sql) {
    return sqlite3_exec(m_handle, sql, nullptr, nullptr, nullptr) == SQLITE_OK;
}

std::optional<std::int64_t> RawDatabase::integer(const QString& sql) {
    Statement query(m_handle, sql);
    return query.step() == SQLITE_ROW ? std::optional<std::int64_t>(sqlite3_column_int64(query.get(), 0))
                                      : std::nullopt;
}

QString RawDatabase::text(const QString& sql) {
    Statement query(m_handle, sql);
    return query.step() == SQLITE_ROW
               ? QString::fromUtf8(reinterpret_cast<const char*>(sqlite3_column_text(query.get(), 0)))
               : QString();
}

std::optional<QByteArray> RawDatabase::valueBits(const QString& table, std::int64_t rowid,
                                                 const QString& column, int& type) {
    Statement query(m_handle, QString("SELECT %1 FROM %2 WHERE rowid = %3").arg(column, table).arg(rowid));
    if (query.step() != SQLITE_ROW)
        return std::nullopt;
    type = sqlite3_column_type(query.get(), 0);
    return bitsOf(query.get(), 0);
}

bool RawDatabase::flip(const QString& table, std::int64_t rowid, const QString& column, std::uint64_t draw) {
    int type = SQLITE_NULL;
    const auto before = valueBits(table, rowid, column, type);
    if (!before || before->isEmpty())
        return false;
    QByteArray bits = *before;
    const std::uint64_t bit = draw % (static_cast<std::uint64_t>(bits.size()) * 8);
    char& byte = bits[static_cast<qsizetype>(bit / 8)];
    byte = static_cast<char>(byte ^ (1 << (bit % 8)));
    {
        Statement update(m_handle,
                         QString("UPDATE %1 SET %2 = ? WHERE rowid = %3").arg(table, column).arg(rowid));
        if (!update.get())
            return false;
        bind(update.get(), 1, type, bits);
        if (update.step() != SQLITE_DONE)
            return false;
    }
    int typeNow = SQLITE_NULL;
    const auto after = valueBits(table, rowid, column, typeNow);
    return !after || *after != *before ||
           typeNow != type; // a key may have moved the row; -0.0 is kept as 0.0
}
