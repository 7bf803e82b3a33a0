// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/upkeep/restorable.h"

#include "database/integrity/snapshot_check.h"
#include "database/privacy/participant_erasure.h"
#include "database/query.h"
#include "database/schema/migration_runner.h"
#include "database/upkeep/manifest.h"
#include "database/upkeep/restore_rights.h"

#include <QFile>
#include <vector>

namespace chiron::database {
namespace {

// Returns all erasures that must be applied: those known to the backup, to the site, and to the file to be
// replaced.
core::Result<std::vector<Erasure>> erasuresToApply(const std::string& backupFolder,
                                                   const std::string& siteFolder, const std::string& target) {
    std::vector<Erasure> all;
    for (const std::string& file : {backupFolder + "/" + kErasuresFile, erasureListFile(siteFolder)}) {
        const auto listed = readErasureList(file);
        if (!listed) {
            return tl::unexpected(listed.error());
        }
        for (const Erasure& erasure : *listed) {
            putErasure(all, erasure);
        }
    }
    if (auto old = Connection::open(target, Connection::Mode::readOnly)) {
        // The file to be replaced may be damaged; then the two lists must suffice.
        for (const Erasure& erasure : storedErasures(**old).value_or(std::vector<Erasure>())) {
            putErasure(all, erasure);
        }
    }
    return all;
}

// Returns whether there is a participant with that code, who was then overwritten again.
core::Result<bool> applyToParticipant(Connection& connection, const Actor& actor, const Erasure& erasure) {
    const auto participant = participantWithCode(connection, erasure.participantCode);
    if (!participant || *participant == 0) {
        return participant ? core::Result<bool>(false) : tl::unexpected(participant.error());
    }
    const auto done = overwriteParticipant(connection, actor, *participant, erasure);
    return done ? core::Result<bool>(true) : tl::unexpected(done.error());
}

core::Result<int> applyErasures(Connection& connection, const Actor& actor,
                                const std::vector<Erasure>& erasures) {
    int applied = 0;
    for (const Erasure& erasure : erasures) {
        Erasure again = erasure;
        const auto administrator =
            selectInteger(connection, "SELECT id FROM person WHERE id = ?", {erasure.administrator});
        if (!administrator)
            return tl::unexpected(administrator.error());
        again.administrator = *administrator ? erasure.administrator : actor.personId();
        if (!erasure.participantCode.empty()) {
            const auto done = applyToParticipant(connection, actor, again);
            if (!done) {
                return tl::unexpected(done.error());
            }
            applied += *done ? 1 : 0;
            continue;
        }
        const auto created = selectText(
            connection, "SELECT created_utc FROM person WHERE id = ? AND kind = 'person'", {erasure.person});
        if (!created) {
            return tl::unexpected(created.error());
        }
        if (!*created || !isAbout(erasure, erasure.person, **created)) {
            continue;
        }
        if (auto done = overwritePerson(connection, actor, again); !done) {
            return tl::unexpected(done.error());
        }
        ++applied;
    }
    return applied;
}

// Brings the copy up to date inside one transaction: applies erasures and adds an entry that says where the
// chain was cut.
core::Result<int> prepare(const std::string& copy, const Actor& actor, const SiteKey& key,
                          const IBootClock* clock, const std::vector<Erasure>& erasures) {
    auto connection = Connection::create(copy);
    if (!connection) {
        return tl::unexpected(connection.error());
    }
    (*connection)->setSite(&key, clock);
    if (auto begun = (*connection)->begin(); !begun) {
        return tl::unexpected(begun.error());
    }
    const auto oldHead = readHeadFile(key);
    const AuditHead cut = oldHead ? oldHead->value_or(AuditHead{}) : AuditHead{};
    auto applied = applyErasures(**connection, actor, erasures);
    if (applied) {
        auto audited = appendAudit(
            **connection, actor,
            {"restore", "meta", 0, std::nullopt,
             "{\"head_count\":" + std::to_string(cut.count) + ",\"head_hash\":\"" + cut.hash + "\"}"});
        applied = audited ? applied : tl::unexpected(audited.error());
    }
    if (!applied) {
        (*connection)->rollback();
        return applied;
    }
    if (auto committed = (*connection)->commit(); !committed) {
        return tl::unexpected(committed.error());
    }
    // WAL mode is set before the copy is put in place: a rollback journal left by a kill would lock out
    // readers.
    auto vacuumed = (*connection)->execute("VACUUM; PRAGMA journal_mode=WAL;");
    return vacuumed ? applied : tl::unexpected(vacuumed.error());
}

core::Result<void> bringCopyUpToDate(const std::string& copy) {
    const MigrationRunner runner;
    const auto present = runner.inspect(copy);
    if (!present || present->version == runner.newest()) {
        return present ? core::Result<void>() : tl::unexpected(present.error());
    }
    auto connection = Connection::create(copy);
    const auto migrated = connection ? runner.migrate(**connection) : tl::unexpected(connection.error());
    if (!migrated) {
        return tl::unexpected(migrated.error());
    }
    QFile::remove(QString::fromStdString(*migrated)); // the backup itself already is the copy of the old
                                                      // version
    return {};
}

} // namespace

core::Result<int> makeRestorable(const std::string& copy, const RestoreRequest& request,
                                 const DatabaseOptions& options, const SiteKey& key, const AuditHead& head) {
    if (auto current = bringCopyUpToDate(copy); !current) {
        return tl::unexpected(current.error());
    }
    const auto actor = restorerIn(copy, request.name, request.password, options);
    if (!actor) {
        return tl::unexpected(actor.error());
    }
    const auto verified = [&](const AuditHead& expected) -> core::Result<void> {
        const VerifyReport report = verifySnapshot(copy, &key, expected);
        return report.ok()
                   ? core::Result<void>()
                   : core::fail(
                         core::ErrorCode::doesNotHold,
                         "the backup does not verify, nothing was changed: " + report.findings.front().table +
                             " " + report.findings.front().row + " " + report.findings.front().detail);
    };
    if (auto good = verified(head); !good) {
        return tl::unexpected(good.error());
    }
    const auto erasures = erasuresToApply(request.backupFolder, key.folder(), request.targetFile);
    if (!erasures) {
        return tl::unexpected(erasures.error());
    }
    const SystemBootClock clock;
    const auto applied = prepare(copy, *actor, key, &clock, *erasures);
    if (!applied) {
        return applied;
    }
    const auto good = verified(head);
    return good ? applied : core::Result<int>(tl::unexpected(good.error()));
}

} // namespace chiron::database
