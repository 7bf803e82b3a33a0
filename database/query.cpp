// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/query.h"

#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QString>
#include <QStringDecoder>
#include <QVariant>
#include <cmath>
#include <sqlite3.h>

namespace chiron::database {
namespace {

core::Result<QVariant> textToQt(const std::string& text) {
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    QString string = decoder.decode(QByteArrayView(text.data(), static_cast<qsizetype>(text.size())));
    const bool altered = text.starts_with("\xef\xbb\xbf") || text.find('\0') != std::string::npos;
    if (decoder.hasError() || altered) { // SQLite would drop a byte order mark, and the digest would not
                                         // match
        return core::fail(
            core::ErrorCode::badInput,
            "a text to be stored is not valid UTF-8, begins with a byte order mark or holds a NUL");
    }
    return QVariant(string.isNull() ? QString(QLatin1String("")) : string);
}

core::Result<QVariant> toQt(const Value& value) {
    switch (value.type()) {
    case Value::Type::null:
        return QVariant();
    case Value::Type::integer:
        return QVariant(static_cast<qlonglong>(value.integer()));
    case Value::Type::real:
        return std::isfinite(value.real())
                   ? core::Result<QVariant>(QVariant(value.real()))
                   : core::fail(core::ErrorCode::badInput, "a number to be stored is not finite");
    case Value::Type::text:
        return textToQt(value.bytes());
    case Value::Type::blob:
        break;
    }
    const std::string& bytes = value.bytes();
    return QVariant(QByteArray(bytes.empty() ? "" : bytes.data(), static_cast<qsizetype>(bytes.size())));
}

core::Error errorOf(const QSqlError& error, const std::string& file, const std::string& sql) {
    const int code = error.nativeErrorCode().toInt();
    const std::string words =
        (error.driverText() + QStringLiteral(": ") + error.databaseText()).toStdString();
    return storageError(file, sql.substr(0, 80), code, words);
}

} // namespace

core::Error storageError(const std::string& file, const std::string& what, int extendedCode,
                         const std::string& words) {
    std::string message = file + ": ";
    switch (extendedCode & 0xff) {
    case SQLITE_FULL:
        message += "the disk is full; nothing of this step was kept";
        break;
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
        message += "the file is damaged";
        break;
    case SQLITE_IOERR:
        message += "the disk could not be read or written (it may be full); nothing of this step was kept";
        break;
    default:
        message += "storage failed";
    }
    message += " (SQLite " + std::to_string(extendedCode) + ", " + words + ", at: " + what + ")";
    return core::Error{core::ErrorCode::storage, std::move(message)};
}

core::Result<Query> Query::run(Connection& connection, const std::string& sql,
                               const std::vector<Value>& values) {
    QSqlQuery query(connection.qt());
    query.setForwardOnly(true);
    if (!query.prepare(QString::fromStdString(sql))) {
        return tl::unexpected(errorOf(query.lastError(), connection.file(), sql));
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        auto bound = toQt(values[i]);
        CHIRON_TRY(bound);
        query.bindValue(static_cast<int>(i), *bound);
    }
    if (!query.exec()) {
        return tl::unexpected(errorOf(query.lastError(), connection.file(), sql));
    }
    return Query(std::move(query), connection.file());
}

core::Result<bool> Query::next() {
    if (m_query.next()) {
        return true;
    }
    if (m_query.lastError().isValid()) {
        return tl::unexpected(errorOf(m_query.lastError(), m_file, "reading rows"));
    }
    return false;
}

bool Query::isNull(int column) const {
    return m_query.value(column).isNull();
}
std::int64_t Query::integer(int column) const {
    return m_query.value(column).toLongLong();
}
double Query::real(int column) const {
    return m_query.value(column).toDouble();
}
std::string Query::text(int column) const {
    return m_query.value(column).toString().toStdString();
}

Blob Query::blob(int column) const {
    const QByteArray bytes = m_query.value(column).toByteArray();
    return Blob(bytes.begin(), bytes.end());
}

Value Query::value(int column) const {
    const QVariant variant = m_query.value(column);
    if (variant.isNull()) {
        return Value();
    }
    switch (variant.typeId()) {
    case QMetaType::LongLong:
    case QMetaType::Int:
        return static_cast<std::int64_t>(variant.toLongLong());
    case QMetaType::Double:
        return variant.toDouble();
    case QMetaType::QByteArray:
        return blob(column);
    default:
        return text(column);
    }
}

core::Result<std::optional<std::int64_t>> selectInteger(Connection& connection, const std::string& sql,
                                                        const std::vector<Value>& values) {
    auto query = Query::run(connection, sql, values);
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    return *row && !query->isNull(0) ? std::optional(query->integer(0)) : std::nullopt;
}

core::Result<std::optional<std::string>> selectText(Connection& connection, const std::string& sql,
                                                    const std::vector<Value>& values) {
    auto query = Query::run(connection, sql, values);
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    return *row && !query->isNull(0) ? std::optional(query->text(0)) : std::nullopt;
}

} // namespace chiron::database
