// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/access/authorise.h"
#include "database/audit/audit_trail.h"
#include "database/query.h"
#include "database/upkeep/snapshot_folder.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

namespace chiron::database {
namespace {

// Secrets remain in the snapshot, which only an administrator can restore.
constexpr const char* kSecretTable = "credential";

core::Result<std::vector<std::string>> namesOf(Connection& connection, const std::string& sql,
                                               const std::vector<Value>& values) {
    auto query = Query::run(connection, sql, values);
    CHIRON_TRY(query);
    std::vector<std::string> names;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        names.push_back(query->text(0));
    }
    CHIRON_TRY(row);
    return names;
}

QJsonValue jsonOf(const Value& value) {
    switch (value.type()) {
    case Value::Type::null:
        return QJsonValue();
    case Value::Type::integer:
        return static_cast<qint64>(value.integer());
    case Value::Type::real:
        return value.real(); // Qt writes the shortest text that reads back to the same double
    case Value::Type::text:
        return QString::fromStdString(value.bytes());
    case Value::Type::blob:
        break;
    }
    return QString::fromStdString(
        hex(reinterpret_cast<const std::uint8_t*>(value.bytes().data()), value.bytes().size()));
}

core::Result<void> writeTable(Connection& connection, const std::string& table, const std::string& name) {
    const auto columns = namesOf(connection, "SELECT name FROM pragma_table_info(?) ORDER BY cid", {table});
    auto rows = Query::run(connection, "SELECT * FROM " + table + " ORDER BY rowid");
    CHIRON_TRY(columns);
    CHIRON_TRY(rows);
    QSaveFile file(QString::fromStdString(name));
    bool written = file.open(QIODevice::WriteOnly);
    auto row = rows->next();
    for (; written && row && *row; row = rows->next()) {
        QJsonObject json;
        for (std::size_t i = 0; i < columns->size(); ++i) {
            json[QString::fromStdString((*columns)[i])] = jsonOf(rows->value(static_cast<int>(i)));
        }
        const QByteArray line = QJsonDocument(json).toJson(QJsonDocument::Compact) + '\n';
        written = file.write(line) == line.size();
    }
    CHIRON_TRY(row);
    return written && file.commit()
               ? core::Result<void>()
               : core::fail(core::ErrorCode::storage, name + ": cannot be written (disk full?)");
}

core::Result<std::vector<std::string>> writeTables(Connection& snapshot, const std::string& folder) {
    if (!QDir().mkpath(QString::fromStdString(folder + "/tables"))) {
        return core::fail(core::ErrorCode::storage, folder + "/tables: cannot be created");
    }
    const auto tables =
        namesOf(snapshot,
                "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite\\_%' "
                "ESCAPE '\\' AND name <> ? ORDER BY name",
                {std::string(kSecretTable)});
    CHIRON_TRY(tables);
    std::vector<std::string> files;
    for (const std::string& table : *tables) {
        const std::string name = "tables/" + table + ".jsonl";
        CHIRON_TRY(writeTable(snapshot, table, folder + "/" + name));
        files.push_back(name);
    }
    return files;
}

} // namespace

core::Result<SnapshotInfo> Upkeep::exportSite(Database& database, const Actor& actor,
                                              const std::string& folder, const std::atomic<bool>* cancel) {
    auto reader = database.openReader();
    CHIRON_TRY(reader);
    CHIRON_TRY(authorise(**reader, actor, Action::exportSite));
    const auto info = writeSnapshotFolder(database, **reader, folder, "export", writeTables, cancel);
    if (!info || !database.isWritable()) {
        return info;
    }
    const auto audited = database.write([&](WriteContext& writing) {
        return appendAudit(writing.connection(), actor, {"exportSite", "meta", 0, std::nullopt, "{}"});
    });
    CHIRON_TRY(audited);
    return info;
}

} // namespace chiron::database
