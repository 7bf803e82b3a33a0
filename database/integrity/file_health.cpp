// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/file_health.h"

#include "database/interruptible.h"
#include "database/query.h"
#include "database/schema/migration_runner.h"

#include <QFile>
#include <QFileInfo>
#include <QtEndian>

namespace chiron::database {
namespace {

constexpr qint64 kHeader_bytes = 100; // size of a SQLite file header

/// Returns the file length that the header states; 0 if it is not binding, because a log beside the file may
/// hold the rest.
qint64 promisedBytes(const QString& name, const QByteArray& header) {
    const auto number = [&header](int at) { return qFromBigEndian<quint32>(header.constData() + at); };
    const bool counted = number(24) == number(92); // otherwise an old program wrote the file and did not
                                                   // update the length
    const qint64 page = qFromBigEndian<quint16>(header.constData() + 16);
    if (!counted || QFileInfo(name + QStringLiteral("-wal")).size() > 0) {
        return 0;
    }
    return (page == 1 ? 65536 : page) * static_cast<qint64>(number(28));
}

QByteArray headerOf(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.read(kHeader_bytes) : QByteArray();
}

std::string cutOff(qint64 length, qint64 promised) {
    return "the file is cut off: " + std::to_string(length) + " bytes of " + std::to_string(promised);
}

bool isCut(const QString& name, const QByteArray& header, std::string& detail) {
    const qint64 promised = promisedBytes(name, header);
    const qint64 length = QFileInfo(name).size();
    detail = cutOff(length, promised);
    return length < promised;
}

/// Returns "ok", or SQLite's first complaint.
core::Result<std::string> quickCheck(Connection& connection, const std::string& table) {
    const auto words = selectText(connection, "PRAGMA quick_check" +
                                                  (table.empty() ? std::string("(1)") : "('" + table + "')"));
    CHIRON_TRY(words);
    return words->value_or("");
}

FileState byPages(const std::string& file, const std::atomic<bool>* cancel) {
    auto connection = Connection::open(file, Connection::Mode::readOnly);
    if (!connection) {
        return {FileHealth::damaged, connection.error().message};
    }
    const Interruptible interruptible(**connection, cancel);
    const auto words = quickCheck(**connection, {});
    if (isSet(cancel) || (words && *words == "ok")) {
        return {};
    }
    return {FileHealth::damaged, words ? *words : words.error().message};
}

} // namespace

FileState examineFile(const std::string& file, const std::atomic<bool>* cancel) {
    const QString name = QString::fromStdString(file);
    const QFileInfo info(name);
    if (!info.exists()) {
        return {FileHealth::missing, file + ": there is no such file"};
    }
    if (!info.isFile() || !info.isReadable()) {
        return {FileHealth::unreadable, file + ": cannot be read"};
    }
    const QByteArray header = headerOf(name);
    if (header.size() < kHeader_bytes || !header.startsWith(QByteArray("SQLite format 3\0", 16))) {
        return {FileHealth::damaged,
                header.isEmpty() ? "the file is empty" : "it does not begin as a database does"};
    }
    const int application = qFromBigEndian<qint32>(header.constData() + 68);
    const int version = qFromBigEndian<qint32>(header.constData() + 60);
    if (application != kApplicationId) {
        return {FileHealth::foreign, "application id " + std::to_string(application)};
    }
    if (version > MigrationRunner().newest()) {
        return {FileHealth::newer, "schema " + std::to_string(version)};
    }
    if (std::string detail; isCut(name, header, detail)) {
        return {FileHealth::damaged, detail};
    }
    return byPages(file, cancel);
}

core::Result<void> checkAtOpening(const std::string& file) {
    const QString name = QString::fromStdString(file);
    const QByteArray header = headerOf(name);
    if (!MigrationRunner().inspect(file)) {
        return {};
    }
    if (std::string detail; isCut(name, header, detail)) {
        return core::fail(core::ErrorCode::storage, file + ": damaged: " + detail);
    }
    auto connection = Connection::open(file, Connection::Mode::readOnly);
    if (!connection) {
        return {};
    }
    for (const char* table : {"meta", "person", "credential"}) {
        const auto words = quickCheck(**connection, table);
        if (!words || *words != "ok") {
            return core::fail(core::ErrorCode::storage,
                              file + ": damaged: " + (words ? *words : words.error().message));
        }
    }
    return {};
}

} // namespace chiron::database
