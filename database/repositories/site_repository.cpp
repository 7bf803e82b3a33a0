// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/site_repository.h"

#include "database/access/authorise.h"
#include "database/access/writer_only.h"
#include "database/accounts/account_rules.h"
#include "database/audit/audit_trail.h"
#include "database/query.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QString>
#include <algorithm>

namespace chiron::database {

namespace {

constexpr const char* kNameKey = "site_name"; // in the table of the site's properties, beside the backup plan

} // namespace

core::Result<std::string> checkedSiteName(const std::string& name) {
    const QString trimmed = QString::fromStdString(name).trimmed();
    if (std::any_of(trimmed.begin(), trimmed.end(),
                    [](QChar c) { return c.category() == QChar::Other_Control; })) {
        return core::fail(core::ErrorCode::badInput,
                          "site name: expected one line without control characters");
    }
    const std::string stored = trimmed.toStdString();
    CHIRON_TRY(checkText("site name", stored, kMaximumSiteNameCharacters));
    return stored;
}

core::Result<std::string> SiteRepository::siteName() {
    CHIRON_TRY(authorise(m_connection, m_actor, Action::siteName));
    const auto name =
        selectText(m_connection, "SELECT value FROM meta WHERE key = ?", {std::string(kNameKey)});
    CHIRON_TRY(name);
    return name->value_or("");
}

core::Result<void> SiteRepository::setSiteName(const std::string& name) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authorise(m_connection, m_actor, Action::setSiteName));
    const auto stored = checkedSiteName(name);
    CHIRON_TRY(stored);
    const auto put = Query::run(
        m_connection,
        "INSERT INTO meta (key, value) VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET value = excluded.value",
        {std::string(kNameKey), *stored});
    CHIRON_TRY(put);
    const QJsonObject detail{{"name", QString::fromStdString(*stored)}};
    return appendAudit(m_connection, m_actor,
                       {"setSiteName", "meta", 0, std::nullopt,
                        QJsonDocument(detail).toJson(QJsonDocument::Compact).toStdString()});
}

} // namespace chiron::database
