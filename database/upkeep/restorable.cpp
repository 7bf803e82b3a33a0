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
        CHIRON_TRY(listed);
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
        CHIRON_TRY(participant);
        return false;
    }
    const auto done = overwriteParticipant(connection, actor, *participant, erasure);
    CHIRON_TRY(done);
    return true;
}

core::Result<int> applyErasures(Connection& connection, const Actor& actor,
                                const std::vector<Erasure>& erasures) {
    int applied = 0;
    for (const Erasure& erasure : erasures) {
        Erasure again = erasure;
        const auto administrator =
            selectInteger(connection, "SELECT id FROM person WHERE id = ?", {erasure.administrator});
        CHIRON_TRY(administrator);
        again.administrator = *administrator ? erasure.administrator : actor.personId();
        if (!erasure.participantCode.empty()) {
            const auto done = applyToParticipant(connection, actor, again);
            CHIRON_TRY(done);
            applied += *done ? 1 : 0;
            continue;
        }
        const auto created = selectText(
            connection, "SELECT created_utc FROM person WHERE id = ? AND kind = 'person'", {erasure.person});
        CHIRON_TRY(created);
        if (!*created || !isAbout(erasure, erasure.person, **created)) {
            continue;
        }
        CHIRON_TRY(overwritePerson(connection, actor, again));
        ++applied;
    }
    return applied;
}

// Brings the copy up to date inside one transaction: applies erasures and adds an entry that says where the
// chain was cut.
core::Result<int> prepare(const std::string& copy, const Actor& actor, const SiteKey& key,
                          const IBootClock* clock, const std::vector<Erasure>& erasures) {
    auto connection = Connection::create(copy);
    CHIRON_TRY(connection);
    (*connection)->setSite(&key, clock);
    CHIRON_TRY((*connection)->begin());
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
    CHIRON_TRY((*connection)->commit());
    // WAL mode is set before the copy is put in place: a rollback journal left by a kill would lock out
    // readers.
    auto vacuumed = (*connection)->execute("VACUUM; PRAGMA journal_mode=WAL;");
    CHIRON_TRY(vacuumed);
    return applied;
}

core::Result<void> bringCopyUpToDate(const std::string& copy) {
    const MigrationRunner runner;
    const auto present = runner.inspect(copy);
    if (!present || present->version == runner.newest()) {
        CHIRON_TRY(present);
        return {};
    }
    auto connection = Connection::create(copy);
    CHIRON_TRY(connection);
    const auto migrated = runner.migrate(**connection);
    CHIRON_TRY(migrated);
    QFile::remove(QString::fromStdString(*migrated)); // the backup itself already is the copy of the old
                                                      // version
    return {};
}

} // namespace

core::Result<int> makeRestorable(const std::string& copy, const RestoreRequest& request,
                                 const DatabaseOptions& options, const SiteKey& key, const AuditHead& head) {
    CHIRON_TRY(bringCopyUpToDate(copy));
    const auto actor = restorerIn(copy, request.name, request.password, options);
    CHIRON_TRY(actor);
    const auto verified = [&](const AuditHead& expected) -> core::Result<void> {
        const VerifyReport report = verifySnapshot(copy, &key, expected);
        return report.ok()
                   ? core::Result<void>()
                   : core::fail(
                         core::ErrorCode::doesNotHold,
                         "the backup does not verify, nothing was changed: " + report.findings.front().table +
                             " " + report.findings.front().row + " " + report.findings.front().detail);
    };
    CHIRON_TRY(verified(head));
    const auto erasures = erasuresToApply(request.backupFolder, key.folder(), request.targetFile);
    CHIRON_TRY(erasures);
    const SystemBootClock clock;
    const auto applied = prepare(copy, *actor, key, &clock, *erasures);
    CHIRON_TRY(applied);
    const auto good = verified(head);
    CHIRON_TRY(good);
    return applied;
}

} // namespace chiron::database
