// SPDX-License-Identifier: GPL-3.0-or-later
#include "access_calls.h"

#include "database/accounts/password_hasher.h"
#include "database/query.h"
#include "database/repositories/account_repository.h"
#include "database/repositories/audit_repository.h"
#include "database/repositories/privacy_repository.h"
#include "database/repositories/site_repository.h"
#include "database/repositories/station_repository.h"

namespace chiron::test {

using namespace database;

std::map<Action, Call> accessCalls(CallWorld& m) {
    using C = Connection;
    using A = const Actor&;
    const std::string hash = PasswordHasher(PasswordCost::minimalForTests()).hash(kPassword).value();
    const NewPerson fresh{"new person", "", {Role::trainee}, hash, false};
    std::map<Action, Call> map;
    const auto add = [&](Action action, Touches touches, bool inJob, auto run) {
        map[action] = {touches, inJob, run};
    };
    const auto none = Touches::nothing;
    const auto person = Touches::person;

    add(Action::hasPeople, none, false,
        [](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).hasPeople()); });
    add(Action::listLoginNames, none, false,
        [](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).listLoginNames()); });
    add(Action::createFirstAdministrator, none, true, [=](C& c, A a, std::int64_t) -> core::Result<void> {
        const auto made = AccountRepository(c, a).createFirstAdministrator(fresh, hash);
        // Permitted, but there are people already: that refusal is another one.
        return !made && made.error().code == core::ErrorCode::wrongUse ? core::Result<void>() : drop(made);
    });
    add(Action::beginLogin, none, true,
        [](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).beginLogin("bob")); });
    add(Action::finishLogin, none, true, [&m](C& c, A a, std::int64_t) {
        return drop(AccountRepository(c, a).finishLogin({m.eve, "x", 0}));
    });
    add(Action::beginRecovery, none, true,
        [](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).beginRecovery("bob")); });
    add(Action::finishRecovery, none, true, [=, &m](C& c, A a, std::int64_t) {
        return AccountRepository(c, a).finishRecovery({m.eve, "x", 0}, hash, hash);
    });
    add(Action::createPerson, none, true,
        [=](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).createPerson(fresh)); });
    add(Action::importPeople, none, true,
        [=](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).importPeople({fresh})); });
    add(Action::recordStationCheck, none, true, [](C& c, A a, std::int64_t) {
        return drop(StationRepository(c, a).recordStationCheck({"loop", "", "1", true}));
    });
    add(Action::siteName, none, false,
        [](C& c, A a, std::int64_t) { return drop(SiteRepository(c, a).siteName()); });
    add(Action::setSiteName, none, true,
        [](C& c, A a, std::int64_t) { return SiteRepository(c, a).setSiteName("North Hospital"); });
    add(Action::listPeople, none, false,
        [](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).listPeople()); });
    add(Action::person, person, false,
        [](C& c, A a, std::int64_t id) { return drop(AccountRepository(c, a).person(id)); });
    add(Action::personByName, person, false, [](C& c, A a, std::int64_t id) {
        const auto name = selectText(c, "SELECT name FROM person WHERE id = ?", {id});
        return name ? drop(AccountRepository(c, a).personByName(name->value_or(""))) : drop(name);
    });
    add(Action::setEnabled, person, true,
        [](C& c, A a, std::int64_t id) { return AccountRepository(c, a).setEnabled(id, false); });
    add(Action::setRoles, person, true,
        [](C& c, A a, std::int64_t id) { return AccountRepository(c, a).setRoles(id, {Role::trainer}); });
    add(Action::changeNames, person, true, [](C& c, A a, std::int64_t id) {
        return AccountRepository(c, a).changeNames(id, "renamed", "Renamed");
    });
    add(Action::changeDisplayName, person, true,
        [](C& c, A a, std::int64_t id) { return AccountRepository(c, a).changeDisplayName(id, "Renamed"); });
    add(Action::earlierNames, person, false,
        [](C& c, A a, std::int64_t id) { return drop(AccountRepository(c, a).earlierNames(id)); });
    add(Action::listEarlierLogins, none, false,
        [](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).listEarlierLogins()); });
    add(Action::hasRecoveryCode, person, false,
        [](C& c, A a, std::int64_t id) { return drop(AccountRepository(c, a).hasRecoveryCode(id)); });
    add(Action::setRecoveryCode, person, true,
        [=](C& c, A a, std::int64_t id) { return AccountRepository(c, a).setRecoveryCode(id, hash); });
    add(Action::changePassword, person, true,
        [=](C& c, A a, std::int64_t id) { return AccountRepository(c, a).changePassword(id, hash); });
    add(Action::resetPassword, person, true,
        [=](C& c, A a, std::int64_t id) { return AccountRepository(c, a).resetPassword(id, hash); });
    add(Action::exportPerson, person, false,
        [](C& c, A a, std::int64_t id) { return drop(PrivacyRepository(c, a).exportPerson(id)); });
    add(Action::erasePerson, person, true, [](C& c, A a, std::int64_t id) {
        return drop(PrivacyRepository(c, a).erasePerson(id, "wish", true));
    });
    add(Action::listErasures, none, false,
        [](C& c, A a, std::int64_t) { return drop(PrivacyRepository(c, a).listErasures()); });
    add(Action::beginSession, none, true,
        [](C& c, A a, std::int64_t) { return drop(SessionRepository(c, a).beginSession(someSession())); });
    add(Action::openSink, Touches::running, true,
        [](C& c, A a, std::int64_t id) { return drop(SessionRepository(c, a).openSink(id)); });
    add(Action::storeTrial, Touches::running, true,
        [](C& c, A a, std::int64_t id) { return SessionRepository(c, a).storeTrial(id, {}); });
    add(Action::storeEvents, Touches::running, true,
        [](C& c, A a, std::int64_t id) { return SessionRepository(c, a).storeEvents(id, {}); });
    add(Action::finishSession, Touches::running, true,
        [](C& c, A a, std::int64_t id) { return SessionRepository(c, a).finishSession(id, {}); });
    add(Action::voidSession, Touches::ended, true,
        [](C& c, A a, std::int64_t id) { return SessionRepository(c, a).voidSession(id, "sneezed"); });
    add(Action::reinstateSession, Touches::ended, true, [](C& c, A a, std::int64_t id) {
        SessionRepository sessions(c, a);
        if (auto voided = sessions.voidSession(id, "sneezed");
            !voided && voided.error().code != core::ErrorCode::wrongUse)
            return voided; // whoever may count it again may void it, too
        return sessions.reinstateSession(id, "did not sneeze");
    });
    add(Action::setArchived, Touches::ended, true,
        [](C& c, A a, std::int64_t id) { return SessionRepository(c, a).setArchived(id, true); });
    add(Action::addComment, Touches::ended, true,
        [](C& c, A a, std::int64_t id) { return drop(SessionRepository(c, a).addComment(id, "good")); });
    add(Action::listSessions, none, false,
        [](C& c, A a, std::int64_t) { return drop(SessionReader(c, a).listSessions()); });
    add(Action::listUnfinished, none, false,
        [](C& c, A a, std::int64_t) { return drop(SessionReader(c, a).listUnfinished()); });
    add(Action::session, Touches::ended, false,
        [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).session(id)); });
    add(Action::trials, Touches::ended, false,
        [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).trials(id)); });
    add(Action::events, Touches::ended, false,
        [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).events(id)); });
    add(Action::secondSummaries, Touches::ended, false,
        [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).secondSummaries(id)); });
    add(Action::comments, Touches::ended, false,
        [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).comments(id)); });
    add(Action::commentedSessions, none, false,
        [](C& c, A a, std::int64_t) { return drop(SessionReader(c, a).commentedSessions()); });
    add(Action::openChunks, Touches::ended, false,
        [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).openChunks(id)); });
    add(Action::storeScores, Touches::ended, true,
        [](C& c, A a, std::int64_t id) { return drop(ScoreRepository(c, a).storeScores(id, someCard())); });
    add(Action::scores, Touches::ended, false,
        [](C& c, A a, std::int64_t id) { return drop(ScoreRepository(c, a).scores(id)); });
    add(Action::scoreSeal, Touches::ended, false,
        [](C& c, A a, std::int64_t id) { return drop(ScoreRepository(c, a).scoreSeal(id)); });
    add(Action::listAudit, none, false,
        [](C& c, A a, std::int64_t) { return drop(AuditRepository(c, a).listAudit()); });
    add(Action::backup, none, false, [&m](C&, A a, std::int64_t) {
        return drop(
            Upkeep::backup(*m.fixture.database, a, m.fixture.path("b" + std::to_string(++m.folders))));
    });
    add(Action::backupStanding, none, false,
        [](C& c, A a, std::int64_t) { return drop(Upkeep::backupStanding(c, a)); });
    add(Action::setBackupPlan, none, true, [](C& c, A a, std::int64_t) {
        return Upkeep::setBackupPlan(c, a, {true, "", 3});
    });
    add(Action::dailyBackup, none, false, [&m](C&, A a, std::int64_t) {
        return drop(Upkeep::dailyBackup(*m.fixture.database, a,
                                        m.fixture.path("d" + std::to_string(++m.folders)), 3));
    });
    add(Action::exportSite, none, false, [&m](C&, A a, std::int64_t) {
        return drop(
            Upkeep::exportSite(*m.fixture.database, a, m.fixture.path("e" + std::to_string(++m.folders))));
    });
    add(Action::restore, none, false, [&m](C&, A a, std::int64_t) {
        DatabaseOptions options = m.fixture.options;
        const std::string key = m.fixture.path() + ".site/site.key";
        return drop(Upkeep::restore(
            {m.backup, m.fixture.path("r" + std::to_string(++m.folders) + ".db"), a.name(), kPassword, key},
            options));
    });
    map.merge(studyCalls());
    return map;
}

} // namespace chiron::test
