// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/query.h"
#include "database/schema/migration_runner.h"
#include "unit/database/database_fixture.h"

#include <QDir>
#include <QFile>

namespace chiron::test {

using namespace chiron::database;

inline constexpr const char* kStoredSite = CHIRON_SOURCE_DIR "/tests/migration/";

inline void copyTo(const std::string& name, const QByteArray& content) {
    QFile file(QString::fromStdString(name));
    if (file.open(QIODevice::WriteOnly | QIODevice::Truncate)) {
        file.write(content);
    }
}

/// The site that version 1 stored, as a database of that version.
inline core::Result<void> makeStoredSite(const std::string& file) {
    auto connection = Connection::create(file);
    CHIRON_TRY(connection);
    auto built = (*connection)
                     ->execute("PRAGMA foreign_keys=OFF; BEGIN;" +
                               contentOf(std::string(kStoredSite) + "v1_site.sql").toStdString() +
                               "COMMIT; PRAGMA application_id=" + std::to_string(kApplicationId) +
                               "; PRAGMA user_version=1; PRAGMA journal_mode=WAL;");
    QDir().mkpath(QString::fromStdString(file + ".site"));
    copyTo(file + ".site/site.key", contentOf(std::string(kStoredSite) + "v1_site.key"));
    copyTo(file + ".site/audit_head.json", contentOf(std::string(kStoredSite) + "v1_audit_head.json"));
    QFile::setPermissions(QString::fromStdString(file + ".site/site.key"),
                          QFile::ReadOwner | QFile::WriteOwner);
    return built;
}

inline std::int64_t numberIn(const std::string& file, const std::string& sql) {
    auto connection = Connection::open(file, Connection::Mode::readOnly);
    const auto value = connection ? selectInteger(**connection, sql) : tl::unexpected(connection.error());
    return value ? value->value_or(-1) : -2;
}

} // namespace chiron::test
