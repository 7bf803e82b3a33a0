// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/audit/audit_trail.h"

#include "core/clock.h"
#include "database/integrity/digested_row.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

namespace chiron::database {
namespace {

void appendBytes(Blob& out, std::string_view text) {
    for (int shift = 0; shift < 64; shift += 8) {
        out.push_back(static_cast<std::uint8_t>(text.size() >> shift));
    }
    out.insert(out.end(), text.begin(), text.end());
}

void appendNumber(Blob& out, std::int64_t number) {
    for (int shift = 0; shift < 64; shift += 8) {
        out.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(number) >> shift));
    }
}

core::Result<std::optional<AuditLink>> lastLink(Connection& connection) {
    auto query = Query::run(connection, "SELECT sequence, mac FROM audit ORDER BY sequence DESC LIMIT 1");
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    if (!*row) {
        return std::optional<AuditLink>();
    }
    AuditLink link;
    link.sequence = query->integer(0);
    link.mac = query->blob(1);
    return std::optional(link);
}

std::string detailOf(const AuditNote& note) {
    if (!note.row) {
        return note.detail;
    }
    const std::string row = "\"row\":\"" + hex(note.row->data(), note.row->size()) + "\"";
    return note.detail == "{}" ? "{" + row + "}"
                               : note.detail.substr(0, note.detail.size() - 1) + "," + row + "}";
}

std::string headFile(const SiteKey& key) {
    return key.folder() + "/audit_head.json";
}

std::string headSignature(const SiteKey& key, const AuditHead& head) {
    Blob bytes;
    appendBytes(bytes, "chiron-audit-head-1");
    appendNumber(bytes, head.count);
    appendBytes(bytes, head.hash);
    const RowDigest mac = key.mac(bytes);
    return hex(mac.data(), mac.size());
}

} // namespace

std::string_view token(ActorKind kind) noexcept {
    switch (kind) {
    case ActorKind::anonymous:
        return "anonymous";
    case ActorKind::simulated:
        return "simulated";
    case ActorKind::maintenance:
        return "maintenance";
    case ActorKind::person:
        return "person";
    }
    return {};
}

core::Result<std::string> databaseIdentity(Connection& connection) {
    const auto text =
        selectText(connection, "SELECT group_concat(key || '=' || value, ';') FROM (SELECT key, value FROM "
                               "meta WHERE key IN ('uuid', 'created_utc', 'demonstration') ORDER BY key)");
    CHIRON_TRY(text);
    return text->value_or("");
}

RowDigest auditGenesis(const SiteKey& key, const std::string& identity) {
    Blob bytes;
    appendBytes(bytes, "chiron-audit-1");
    appendBytes(bytes, identity);
    return key.mac(bytes);
}

RowDigest auditMac(const SiteKey& key, const AuditLink& link) {
    Blob bytes;
    appendNumber(bytes, link.sequence);
    appendBytes(bytes, link.utc);
    appendBytes(bytes, link.actorKind);
    appendNumber(bytes, link.actor);
    appendBytes(bytes, link.action);
    appendBytes(bytes, link.target);
    appendNumber(bytes, link.targetId);
    appendBytes(bytes, link.detailJson);
    bytes.insert(bytes.end(), link.previous.begin(), link.previous.end());
    return key.mac(bytes);
}

core::Result<void> appendAudit(Connection& connection, const Actor& actor, const AuditNote& note) {
    const SiteKey* key = connection.siteKey();
    if (key == nullptr) {
        return core::fail(core::ErrorCode::storage,
                          connection.file() + ": no site key, so nothing can be audited");
    }
    auto last = lastLink(connection);
    auto identity = databaseIdentity(connection);
    CHIRON_TRY(last);
    CHIRON_TRY(identity);
    AuditLink link;
    link.sequence = *last ? (*last)->sequence + 1 : 1;
    link.utc = core::utcNowIso8601();
    link.actorKind = token(actor.kind());
    link.actor = actor.personId();
    link.action = note.action;
    link.target = note.target;
    link.targetId = note.targetId;
    link.detailJson = detailOf(note);
    link.previous = *last ? (*last)->mac : toBlob(auditGenesis(*key, *identity));
    link.mac = toBlob(auditMac(*key, link));
    auto done =
        Query::run(connection,
                   "INSERT INTO audit (sequence, utc, actor_kind, actor_id, action, target, target_id, "
                   "detail_json, previous, mac) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                   {link.sequence, link.utc, link.actorKind, link.actor, link.action, link.target,
                    link.targetId, link.detailJson, link.previous, link.mac});
    CHIRON_TRY(done);
    return {};
}

core::Result<AuditHead> auditHead(Connection& connection) {
    auto last = lastLink(connection);
    CHIRON_TRY(last);
    return *last ? AuditHead{(*last)->sequence, hex((*last)->mac)} : AuditHead{};
}

core::Result<void> writeHeadFile(const SiteKey& key, const AuditHead& head) {
    const QJsonObject json{{"count", static_cast<qint64>(head.count)},
                           {"hash", QString::fromStdString(head.hash)},
                           {"signature", QString::fromStdString(headSignature(key, head))}};
    QSaveFile file(QString::fromStdString(headFile(key)));
    const QByteArray text = QJsonDocument(json).toJson();
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
        return core::fail(core::ErrorCode::storage, headFile(key) + ": the audit head cannot be written");
    }
    return {};
}

core::Result<std::optional<AuditHead>> readHeadFile(const SiteKey& key) {
    QFile file(QString::fromStdString(headFile(key)));
    if (!file.exists()) {
        return std::optional<AuditHead>();
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return core::fail(core::ErrorCode::storage, headFile(key) + ": cannot be read");
    }
    const QJsonObject json = QJsonDocument::fromJson(file.read(4096)).object();
    const AuditHead head{json["count"].toInteger(-1), json["hash"].toString().toStdString()};
    if (head.count < 0 || json["signature"].toString().toStdString() != headSignature(key, head)) {
        return core::fail(core::ErrorCode::doesNotHold,
                          headFile(key) + ": malformed, or not signed with this site's key");
    }
    return std::optional(head);
}

} // namespace chiron::database
