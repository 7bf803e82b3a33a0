// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clock.h"
#include "database/access/authorise.h"
#include "database/access/writer_only.h"
#include "database/accounts/account_rules.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"
#include "database/repositories/account_repository.h"
#include "database/repositories/study_rules.h"

#include <QJsonDocument>
#include <QJsonObject>

// Current and earlier names of people.
namespace chiron::database {
namespace {

// The names are covered through their hash, so that an erasure can overwrite them without changing the chain.
core::Result<void> keepNames(Connection& connection, const Actor& actor, PersonId person,
                             const std::string& name, const std::string& displayName) {
    const auto last = selectInteger(connection, "SELECT max(id) FROM person_name");
    CHIRON_TRY(last);
    const QJsonObject names{{"display_name", QString::fromStdString(displayName)},
                            {"name", QString::fromStdString(name)},
                            {"nonce", QString::fromStdString(randomNonce())}};
    const std::string json = QJsonDocument(names).toJson(QJsonDocument::Compact).toStdString();
    const std::int64_t id = last->value_or(0) + 1;
    const auto row = insertRow(connection, "person_name",
                               {{"id", id},
                                {"person_id", person},
                                {"until_utc", core::utcNowIso8601()},
                                {"changed_by", actor.personId()},
                                {"names_json", json},
                                {"names_hash", toBlob(textDigest(json))}});
    CHIRON_TRY(row);
    return appendAudit(connection, actor, {"keepNames", "person_name", id, *row, "{}"});
}

} // namespace

core::Result<void> AccountRepository::nameIsFree(const std::string& name, PersonId otherThan) {
    const auto taken = selectInteger(m_connection, "SELECT id FROM person WHERE name_key = ? AND id <> ?",
                                     {nameKey(name), otherThan});
    CHIRON_TRY(taken);
    return *taken ? core::fail(core::ErrorCode::badInput,
                               "the name \"" + name + "\" is taken (names differ by more than case)")
                  : core::Result<void>();
}

core::Result<void> AccountRepository::changeNames(PersonId id, const std::string& name,
                                                  const std::string& displayName) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authorise(m_connection, m_actor, Action::changeNames));
    return storeNames("changeNames", id, name, displayName);
}

core::Result<void> AccountRepository::changeDisplayName(PersonId id, const std::string& displayName) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authoriseFor(m_connection, m_actor, Action::changeDisplayName, id));
    return storeNames("changeDisplayName", id, std::nullopt, displayName);
}

core::Result<void> AccountRepository::storeNames(const char* action, PersonId id,
                                                 const std::optional<std::string>& newName,
                                                 const std::string& displayName) {
    const auto before =
        selectText(m_connection, "SELECT name FROM person WHERE id = ? AND kind = 'person'", {id});
    const auto shown = selectText(m_connection, "SELECT display_name FROM person WHERE id = ?", {id});
    CHIRON_TRY(before);
    CHIRON_TRY(shown);
    if (!*before) {
        return core::fail(core::ErrorCode::notFound, "there is no person " + std::to_string(id));
    }
    const std::string name = newName.value_or(**before);
    auto good = checkNames(name, displayName);
    good = good ? nameIsFree(name, id) : good;
    if (!good || (**before == name && shown->value_or("") == displayName)) {
        return good;
    }
    CHIRON_TRY(keepNames(m_connection, m_actor, id, **before, shown->value_or("")));
    const auto row = updateRow(m_connection, "person", {{"id", id}},
                               {{"name", name}, {"name_key", nameKey(name)}, {"display_name", displayName}});
    CHIRON_TRY(row);
    return appendAudit(m_connection, m_actor, {action, "person", id, *row, "{}"});
}

core::Result<std::vector<EarlierName>> AccountRepository::earlierNames(PersonId id) {
    CHIRON_TRY(authoriseFor(m_connection, m_actor, Action::earlierNames, id));
    auto query =
        Query::run(m_connection,
                   "SELECT id, names_json, until_utc, changed_by FROM person_name WHERE person_id = ? "
                   "AND names_json <> '' ORDER BY id DESC",
                   {id});
    CHIRON_TRY(query);
    std::vector<EarlierName> names;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(query->text(1))).object();
        names.push_back({query->integer(0), json["name"].toString().toStdString(),
                         json["display_name"].toString().toStdString(), query->text(2), query->integer(3)});
    }
    CHIRON_TRY(row);
    return names;
}

core::Result<std::vector<EarlierLogin>> AccountRepository::listEarlierLogins() {
    CHIRON_TRY(authorise(m_connection, m_actor, Action::listEarlierLogins));
    auto query =
        Query::run(m_connection,
                   "SELECT n.person_id, n.names_json FROM person_name n JOIN person p ON p.id = n.person_id "
                   "WHERE n.names_json <> '' AND p.kind = 'person' ORDER BY n.id DESC");
    CHIRON_TRY(query);
    std::vector<EarlierLogin> logins;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(query->text(1))).object();
        logins.push_back({query->integer(0), json["name"].toString().toStdString(),
                          json["display_name"].toString().toStdString()});
    }
    CHIRON_TRY(row);
    return logins;
}

} // namespace chiron::database
