// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "database/access/authorise.h"
#include "database/accounts/password_hasher.h"
#include "database/query.h"
#include "database/repositories/account_repository.h"
#include "database/repositories/audit_repository.h"
#include "database/repositories/privacy_repository.h"
#include "database/upkeep/upkeep.h"

#include <QDir>
#include <QRegularExpression>
#include <functional>
#include <map>
#include <set>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

struct Who {
    QString title;
    Actor actor;
    ActorKind kind;
    RoleSet roles;
    SessionId running = 0; ///< own, where somebody has sessions
    SessionId ended = 0;
};

/// Whose thing a call touches.
enum class Touches { nothing, person, running, ended };
enum class Whose { own, simulated, other };

struct Call {
    Touches touches;
    bool inJob; ///< on the writer's connection, undone afterwards
    std::function<core::Result<void>(Connection&, const Actor&, std::int64_t target)> run;
};

template <class T> core::Result<void> drop(const core::Result<T>& result) {
    return result ? core::Result<void>() : core::Result<void>(tl::unexpected(result.error()));
}

} // namespace

/// The role x action table, held against what each function really does.
class TestAccess : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void everyFunctionHasARowAndACall();
    void everyPublicFunctionIsListed();
    void functionsDoAsTheTableSays_data();
    void functionsDoAsTheTableSays();
    void whatMattersMostIsSpeltOut();
    void rolesAdd();
    void disabledAndForcedAccountsMayNothing();
    void listsShowOnlyWhatIsInReach();
    void namesAreHiddenFromResearchers();

private:
    std::map<Action, Call> calls();
    core::Result<void> perform(const Call& call, const Actor& actor, std::int64_t target);
    std::int64_t targetOf(Action action, const Call& call, const Who& who, Whose whose) const;

    DatabaseFixture m;
    std::vector<Who> m_people;
    Who m_bob{"bob", Actor::anonymous(), ActorKind::person, {}};
    PersonId m_eve = 0; ///< a trainee without sessions
    std::string m_backup;
    int m_folders = 0;
};

void TestAccess::initTestCase() {
    REQUIRE(m.create());
    const auto admin = m.administrator();
    REQUIRE(admin);
    const auto withSessions = [&](Who& who) -> core::Result<void> {
        const auto ended = storeSession(*m.database, who.actor);
        const auto running = m.database->write([&](WriteContext& w) {
            return SessionRepository(w.connection(), who.actor).beginSession(someSession());
        });
        who.ended = ended.value_or(0);
        who.running = running.value_or(0);
        return ended ? drop(running) : drop(ended);
    };
    m_people.push_back({"anonymous", Actor::anonymous(), ActorKind::anonymous, {}});
    m_people.push_back({"simulated", Actor::simulated(), ActorKind::simulated, {}});
    m_people.push_back({"maintenance", Actor::maintenance(), ActorKind::maintenance, {}});
    for (const Role role : {Role::trainee, Role::trainer, Role::researcher}) {
        const std::string name(token(role));
        const auto person = m.person(*admin, name, {role});
        REQUIRE(person);
        m_people.push_back({QString::fromStdString(name), *person, ActorKind::person, {role}});
    }
    m_people.push_back({"admin", *admin, ActorKind::person, {Role::admin}});
    for (Who& who : m_people) {
        if (who.kind == ActorKind::person || who.kind == ActorKind::simulated) {
            REQUIRE(withSessions(who));
        }
    }
    const auto bob = m.person(*admin, "bob", {Role::trainee});
    const auto eve = m.person(*admin, "eve", {Role::trainee});
    REQUIRE(bob);
    REQUIRE(eve);
    m_bob.actor = *bob;
    REQUIRE(withSessions(m_bob));
    m_eve = eve->personId();
    m_backup = m.path("backup");
    REQUIRE(Upkeep::backup(*m.database, *admin, m_backup));
}

std::map<Action, Call> TestAccess::calls() {
    using C = Connection;
    using A = const Actor&;
    const std::string hash = PasswordHasher(PasswordCost::minimalForTests()).hash(kPassword).value();
    const NewPerson fresh{"new person", "", {Role::trainee}, hash, false};
    std::map<Action, Call> map;
    const auto add = [&](Action action, Touches touches, bool inJob, auto run) { map[action] = {touches, inJob, run}; };
    const auto none = Touches::nothing;
    const auto person = Touches::person;

    add(Action::createFirstAdministrator, none, true, [=](C& c, A a, std::int64_t) -> core::Result<void> {
        const auto made = AccountRepository(c, a).createFirstAdministrator(fresh, hash);
        // Permitted, but there are people already: that refusal is another one.
        return !made && made.error().code == core::ErrorCode::wrongUse ? core::Result<void>() : drop(made);
    });
    add(Action::beginLogin, none, true, [](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).beginLogin("bob")); });
    add(Action::finishLogin, none, true, [this](C& c, A a, std::int64_t) {
        return drop(AccountRepository(c, a).finishLogin({m_eve, "x", 0}));
    });
    add(Action::beginRecovery, none, true, [](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).beginRecovery("bob")); });
    add(Action::finishRecovery, none, true, [=, this](C& c, A a, std::int64_t) {
        return AccountRepository(c, a).finishRecovery({m_eve, "x", 0}, hash, hash);
    });
    add(Action::createPerson, none, true, [=](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).createPerson(fresh)); });
    add(Action::importPeople, none, true, [=](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).importPeople({fresh})); });
    add(Action::listPeople, none, false, [](C& c, A a, std::int64_t) { return drop(AccountRepository(c, a).listPeople()); });
    add(Action::person, person, false, [](C& c, A a, std::int64_t id) { return drop(AccountRepository(c, a).person(id)); });
    add(Action::personByName, person, false, [](C& c, A a, std::int64_t id) {
        const auto name = selectText(c, "SELECT name FROM person WHERE id = ?", {id});
        return drop(AccountRepository(c, a).personByName(name->value_or("")));
    });
    add(Action::setEnabled, person, true, [](C& c, A a, std::int64_t id) { return AccountRepository(c, a).setEnabled(id, false); });
    add(Action::setRoles, person, true, [](C& c, A a, std::int64_t id) { return AccountRepository(c, a).setRoles(id, {Role::trainer}); });
    add(Action::changePassword, person, true, [=](C& c, A a, std::int64_t id) { return AccountRepository(c, a).changePassword(id, hash); });
    add(Action::resetPassword, person, true, [=](C& c, A a, std::int64_t id) { return AccountRepository(c, a).resetPassword(id, hash); });
    add(Action::exportPerson, person, false, [](C& c, A a, std::int64_t id) { return drop(PrivacyRepository(c, a).exportPerson(id)); });
    add(Action::erasePerson, person, true, [](C& c, A a, std::int64_t id) { return drop(PrivacyRepository(c, a).erasePerson(id, "wish", true)); });
    add(Action::listErasures, none, false, [](C& c, A a, std::int64_t) { return drop(PrivacyRepository(c, a).listErasures()); });
    add(Action::beginSession, none, true, [](C& c, A a, std::int64_t) { return drop(SessionRepository(c, a).beginSession(someSession())); });
    add(Action::openSink, Touches::running, true, [](C& c, A a, std::int64_t id) { return drop(SessionRepository(c, a).openSink(id)); });
    add(Action::storeTrial, Touches::running, true, [](C& c, A a, std::int64_t id) { return SessionRepository(c, a).storeTrial(id, {}); });
    add(Action::storeEvents, Touches::running, true, [](C& c, A a, std::int64_t id) { return SessionRepository(c, a).storeEvents(id, {}); });
    add(Action::finishSession, Touches::running, true, [](C& c, A a, std::int64_t id) { return SessionRepository(c, a).finishSession(id, {}); });
    add(Action::voidSession, Touches::ended, true, [](C& c, A a, std::int64_t id) { return SessionRepository(c, a).voidSession(id, "sneezed"); });
    add(Action::setArchived, Touches::ended, true, [](C& c, A a, std::int64_t id) { return SessionRepository(c, a).setArchived(id, true); });
    add(Action::addComment, Touches::ended, true, [](C& c, A a, std::int64_t id) { return drop(SessionRepository(c, a).addComment(id, "good")); });
    add(Action::listSessions, none, false, [](C& c, A a, std::int64_t) { return drop(SessionReader(c, a).listSessions()); });
    add(Action::listUnfinished, none, false, [](C& c, A a, std::int64_t) { return drop(SessionReader(c, a).listUnfinished()); });
    add(Action::session, Touches::ended, false, [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).session(id)); });
    add(Action::trials, Touches::ended, false, [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).trials(id)); });
    add(Action::events, Touches::ended, false, [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).events(id)); });
    add(Action::secondSummaries, Touches::ended, false, [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).secondSummaries(id)); });
    add(Action::comments, Touches::ended, false, [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).comments(id)); });
    add(Action::openChunks, Touches::ended, false, [](C& c, A a, std::int64_t id) { return drop(SessionReader(c, a).openChunks(id)); });
    add(Action::storeScores, Touches::ended, true, [](C& c, A a, std::int64_t id) { return drop(ScoreRepository(c, a).storeScores(id, someCard())); });
    add(Action::scores, Touches::ended, false, [](C& c, A a, std::int64_t id) { return drop(ScoreRepository(c, a).scores(id)); });
    add(Action::listAudit, none, false, [](C& c, A a, std::int64_t) { return drop(AuditRepository(c, a).listAudit()); });
    add(Action::backup, none, false, [this](C&, A a, std::int64_t) {
        return drop(Upkeep::backup(*m.database, a, m.path("b" + std::to_string(++m_folders))));
    });
    add(Action::exportSite, none, false, [this](C&, A a, std::int64_t) {
        return drop(Upkeep::exportSite(*m.database, a, m.path("e" + std::to_string(++m_folders))));
    });
    add(Action::restore, none, false, [this](C&, A a, std::int64_t) {
        DatabaseOptions options = m.options;
        const std::string key = m.path() + ".site/site.key";
        return drop(Upkeep::restore({m_backup, m.path("r" + std::to_string(++m_folders) + ".db"), a.name(), kPassword, key}, options));
    });
    return map;
}

void TestAccess::everyFunctionHasARowAndACall() {
    const auto made = calls();
    for (int i = 0; i < static_cast<int>(Action::count); ++i) {
        const auto action = static_cast<Action>(i);
        const std::string name(token(action));
        QVERIFY2(accessRow(action).has_value(), (name + " has no row in the access table").c_str());
        QVERIFY2(made.contains(action), (name + " is not called by this test").c_str());
    }
    QCOMPARE(scopeOf(Action::count, ActorKind::person, {Role::admin}), Scope::none); // no row: denied
}

void TestAccess::everyPublicFunctionIsListed() {
    std::set<QString> listed;
#define LISTED(class_, function) listed.insert(QStringLiteral(#class_ "::" #function));
    CHIRON_REPOSITORY_FUNCTIONS(LISTED)
#undef LISTED
    std::set<QString> found;
    const QDir root(QStringLiteral(CHIRON_SOURCE_DIR "/database"));
    QStringList headers;
    for (const QString& folder : {QStringLiteral("repositories"), QStringLiteral("upkeep")}) {
        for (const QString& name : QDir(root.filePath(folder)).entryList({QStringLiteral("*.h")})) {
            headers.append(root.filePath(folder + "/" + name));
        }
    }
    static const QRegularExpression classLine(QStringLiteral("^class (\\w+) \\{"));
    static const QRegularExpression function(QStringLiteral("^    (?:static )?core::Result<.*> (\\w+)\\("));
    for (const QString& header : headers) {
        QFile file(header);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QString inside;
        bool isPublic = false;
        for (const QString& line : QString::fromUtf8(file.readAll()).split('\n')) {
            if (const auto match = classLine.match(line); match.hasMatch()) {
                inside = match.captured(1);
            }
            isPublic = line == QLatin1String("public:") || (isPublic && line != QLatin1String("private:") && line != QLatin1String("};"));
            if (const auto match = function.match(line); isPublic && match.hasMatch()) {
                found.insert(inside + "::" + match.captured(1));
            }
        }
    }
    QCOMPARE(found, listed);
}

void TestAccess::functionsDoAsTheTableSays_data() {
    QTest::addColumn<int>("action");
    for (int i = 0; i < static_cast<int>(Action::count); ++i) {
        QTest::newRow(std::string(token(static_cast<Action>(i))).c_str()) << i;
    }
}

core::Result<void> TestAccess::perform(const Call& call, const Actor& actor, std::int64_t target) {
    if (!call.inJob) {
        auto reader = m.database->openReader();
        return reader ? call.run(**reader, actor, target) : drop(reader);
    }
    core::Result<void> outcome;
    (void)m.database->write([&](WriteContext& w) -> core::Result<void> {
        outcome = call.run(w.connection(), actor, target);
        return core::fail(core::ErrorCode::cancelled, "undone");
    });
    return outcome;
}

std::int64_t TestAccess::targetOf(Action action, const Call& call, const Who& who, Whose whose) const {
    const Who& simulated = m_people[1];
    const Who& owner = whose == Whose::own ? who : whose == Whose::simulated ? simulated : m_bob;
    switch (call.touches) {
    case Touches::nothing:
        return -1;
    case Touches::person:
        // What only administrators do to others is tried on somebody without a running session.
        return whose == Whose::other && action != Action::exportPerson ? m_eve : owner.actor.personId();
    case Touches::running:
        return owner.running;
    case Touches::ended:
        return owner.ended;
    }
    return 0;
}

void TestAccess::functionsDoAsTheTableSays() {
    QFETCH(int, action);
    const auto what = static_cast<Action>(action);
    const auto made = calls();
    const Call& call = made.at(what);
    for (const Who& who : m_people) {
        const Scope scope = scopeOf(what, who.kind, who.roles);
        std::vector<Whose> cases{Whose::other};
        if (call.touches != Touches::nothing && who.actor.personId() != 0) {
            cases.push_back(Whose::own);
        }
        if (call.touches == Touches::ended || call.touches == Touches::running) {
            cases.push_back(Whose::simulated);
        }
        for (const Whose whose : cases) {
            const bool isOwn = whose == Whose::own || (whose == Whose::simulated && who.kind == ActorKind::simulated);
            const bool isSimulated = whose == Whose::simulated || (isOwn && who.kind == ActorKind::simulated);
            const bool expected = call.touches == Touches::nothing
                                      ? scope != Scope::none
                                      : scope == Scope::all || (isOwn && (scope == Scope::own || scope == Scope::ownAndSimulated)) ||
                                            (isSimulated && (scope == Scope::simulated || scope == Scope::ownAndSimulated));
            const auto outcome = perform(call, who.actor, targetOf(what, call, who, whose));
            const QString place = who.title + (isOwn ? " own" : isSimulated ? " simulated" : " other") + ": " +
                                  (outcome ? QStringLiteral("done") : QString::fromStdString(outcome.error().message));
            if (expected) {
                // Passing the check is not enough: it must work, unless a rule of its own forbids it (oneself).
                const bool oneself = isOwn && who.roles.contains(Role::admin) && !outcome && outcome.error().code == core::ErrorCode::wrongUse;
                QVERIFY2(outcome || oneself, qPrintable(place));
            } else {
                QVERIFY2(!outcome && outcome.error().code == core::ErrorCode::notAllowed, qPrintable(place));
            }
        }
    }
}

void TestAccess::whatMattersMostIsSpeltOut() {
    // Not read from the table: the rules as data.md and cli.md state them.
    using K = ActorKind;
    for (const Role role : {Role::trainee, Role::trainer, Role::researcher}) {
        for (const Action action : {Action::createPerson, Action::importPeople, Action::setRoles, Action::setEnabled, Action::resetPassword,
                                    Action::erasePerson, Action::backup, Action::restore, Action::exportSite, Action::listAudit}) {
            QCOMPARE(scopeOf(action, K::person, {role}), Scope::none);
        }
    }
    QCOMPARE(scopeOf(Action::session, K::person, {Role::trainee}), Scope::ownAndSimulated);
    QCOMPARE(scopeOf(Action::listPeople, K::person, {Role::trainee}), Scope::none);
    QCOMPARE(scopeOf(Action::voidSession, K::person, {Role::trainee}), Scope::none);
    QCOMPARE(scopeOf(Action::session, K::anonymous, {}), Scope::simulated);
    QCOMPARE(scopeOf(Action::beginSession, K::anonymous, {}), Scope::none);
    QCOMPARE(scopeOf(Action::beginSession, K::simulated, {}), Scope::own);
    QCOMPARE(scopeOf(Action::session, K::simulated, {}), Scope::simulated);
    QCOMPARE(scopeOf(Action::listPeople, K::simulated, {}), Scope::none);
    // Nobody stores a result for somebody else, but maintenance after a crash.
    for (const Action action : {Action::beginSession, Action::storeTrial, Action::storeScores, Action::finishSession}) {
        for (const Role role : kAllRoles) {
            QCOMPARE(scopeOf(action, K::person, {role}), Scope::own);
        }
    }
}

void TestAccess::rolesAdd() {
    QCOMPARE(scopeOf(Action::session, ActorKind::person, {Role::trainee, Role::trainer}), Scope::all);
    QCOMPARE(scopeOf(Action::createPerson, ActorKind::person, {Role::trainee, Role::admin}), Scope::all);
    QCOMPARE(scopeOf(Action::exportPerson, ActorKind::person, {Role::trainee, Role::researcher}), Scope::own);
    QCOMPARE(scopeOf(Action::session, ActorKind::person, {}), Scope::none);
}

void TestAccess::disabledAndForcedAccountsMayNothing() {
    const Actor admin = m_people.back().actor;
    const auto zoe = m.person(admin, "zoe", {Role::admin});
    REQUIRE(zoe);
    AccountService accounts(*m.database);
    REQUIRE(accounts.listPeople(*zoe));
    REQUIRE(accounts.resetPassword(admin, zoe->personId(), "another horse 7"));
    QCOMPARE(accounts.listPeople(*zoe).error().code, core::ErrorCode::notAllowed); // an actor from before the reset
    const auto forced = accounts.login("zoe", "another horse 7");
    REQUIRE(forced);
    QVERIFY(forced->mustChangePassword());
    QCOMPARE(accounts.listPeople(*forced).error().code, core::ErrorCode::notAllowed);
    REQUIRE(accounts.changePassword(*forced, "another horse 7", "third horse 55"));
    REQUIRE(accounts.listPeople(*forced));
    REQUIRE(accounts.setEnabled(admin, zoe->personId(), false));
    QCOMPARE(accounts.listPeople(*forced).error().code, core::ErrorCode::notAllowed);
    QCOMPARE(accounts.login("zoe", "third horse 55").error().code, core::ErrorCode::notAllowed);
}

void TestAccess::listsShowOnlyWhatIsInReach() {
    auto reader = m.database->openReader();
    REQUIRE(reader);
    for (const Who& who : m_people) {
        const auto listed = SessionReader(**reader, who.actor).listSessions();
        REQUIRE(listed);
        const Scope scope = scopeOf(Action::listSessions, who.kind, who.roles);
        for (const SessionSummary& session : *listed) {
            const bool own = session.person == who.actor.personId();
            const bool simulated = session.person == Actor::kSimulatedPerson;
            QVERIFY2(scope == Scope::all || (own && scope == Scope::ownAndSimulated) || (simulated && scope != Scope::own),
                     qPrintable(who.title));
        }
        QVERIFY(!listed->empty());
        SessionFilter bobs;
        bobs.person = m_bob.actor.personId();
        const auto theirs = SessionReader(**reader, who.actor).listSessions(bobs);
        REQUIRE(theirs);
        QCOMPARE(theirs->empty(), scope != Scope::all);
    }
    const auto everybody = AccountService(*m.database).listPeople(m_people.back().actor);
    REQUIRE(everybody);
    for (const Person& person : *everybody) {
        QVERIFY(person.name != "simulated");
    }
}

void TestAccess::namesAreHiddenFromResearchers() {
    auto reader = m.database->openReader();
    for (const Who& who : m_people) {
        if (scopeOf(Action::session, who.kind, who.roles) != Scope::all) {
            continue;
        }
        const auto record = SessionReader(**reader, who.actor).session(m_bob.ended);
        REQUIRE(record);
        const bool names = scopeOf(Action::listPeople, who.kind, who.roles) == Scope::all;
        QCOMPARE(record->summary.personName == "bob", names);
        QVERIFY(names || record->summary.personName.starts_with("P-"));
    }
}

QTEST_GUILESS_MAIN(TestAccess)
#include "test_access.moc"
