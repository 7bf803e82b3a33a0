// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "core/result.h"
#include "database/database.h"
#include "session/recovery.h"

#include <QFileInfo>
#include <QString>
#include <memory>
#include <vector>

namespace chiron::desktop {

/// The database that the program works on, and its content. A worker opens the database with openSite(),
/// which also recovers crashed sessions, and passes it here.
/// Thread: GUI; workers may use `database()` while the site is open.
class DesktopSite {
public:
    explicit DesktopSite(QString databaseFile, database::DatabaseOptions options = {})
        : m_file(std::move(databaseFile)), m_options(std::move(options)) {}
    DesktopSite(const DesktopSite&) = delete;
    DesktopSite& operator=(const DesktopSite&) = delete;

    const QString& file() const noexcept { return m_file; }
    void setFile(const QString& file) { m_file = file; }
    bool exists() const { return QFileInfo::exists(m_file); } ///< if false, the first-start screen appears
    const database::DatabaseOptions& options() const noexcept { return m_options; }

    bool isOpen() const noexcept { return m_database != nullptr; }
    void setOpened(std::unique_ptr<database::Database> database,
                   std::vector<session::RecoveredSession> recovered) {
        m_database = std::move(database);
        m_recovered = std::move(recovered);
    }
    /// Call it only while no work is in progress (Background::cancelAndWait).
    void close() { m_database.reset(); }
    database::Database& database() { return *m_database; } ///< only if isOpen()
    const std::vector<session::RecoveredSession>& recovered() const noexcept { return m_recovered; }

    void setCatalogue(catalogue::Catalogue catalogue) { m_catalogue = std::move(catalogue); }
    const catalogue::Catalogue& catalogue() const noexcept { return m_catalogue; }

private:
    QString m_file;
    database::DatabaseOptions m_options;
    std::unique_ptr<database::Database> m_database;
    std::vector<session::RecoveredSession> m_recovered;
    catalogue::Catalogue m_catalogue;
};

} // namespace chiron::desktop
