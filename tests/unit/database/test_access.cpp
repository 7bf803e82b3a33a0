// SPDX-License-Identifier: GPL-3.0-or-later
#include "access_calls.h"
#include "study_site.h"

#include "database/access/authorise.h"

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
    StudyTargets study{};
};

enum class Whose { own, simulated, other };

} // namespace

/// The role x action table, held against what each function really does.
class TestAccess : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void everyFunctionHasARowAndACall();
    void functionsDoAsTheTableSays_data();
    void functionsDoAsTheTableSays();
    void writesBelongToAJob_data();
    void writesBelongToAJob();
    void disabledAndForcedAccountsMayNothing();
    void listsShowOnlyWhatIsInReach();
    void namesAreHiddenFromResearchers();

private:
    core::Result<void> perform(const Call& call, const Actor& actor, std::int64_t target);
    std::int64_t targetOf(Action action, const Call& call, const Who& who, Whose whose) const;

    CallWorld m_world;
    DatabaseFixture& m = m_world.fixture;
    std::vector<Who> m_people;
    Who m_bob{"bob", Actor::anonymous(), ActorKind::person, {}};
    Who m_ruth{"ruth", Actor::anonymous(), ActorKind::person, {}}; ///< a researcher with studies
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
    m_world.eve = eve->personId();
    const auto ruth = m.person(*admin, "ruth", {Role::researcher});
    REQUIRE(ruth);
    m_ruth.actor = *ruth;
    m_people.push_back(m_ruth);
    for (Who& who : m_people) {
        if (who.kind == ActorKind::simulated || who.title == "researcher" || who.title == "admin" ||
            who.title == "ruth") {
            const auto made = makeStudies(*m.database, who.actor, who.title.toStdString());
            REQUIRE(made);
            who.study = *made;
        }
    }
    m_ruth = m_people.back();
    m_people.pop_back();
    m_world.backup = m.path("backup");
    REQUIRE(Upkeep::backup(*m.database, *admin, m_world.backup));
}

void TestAccess::everyFunctionHasARowAndACall() {
    const auto made = accessCalls(m_world);
    for (int i = 0; i < static_cast<int>(Action::count); ++i) {
        const auto action = static_cast<Action>(i);
        const std::string name(token(action));
        QVERIFY2(accessRow(action).has_value(), (name + " has no row in the access table").c_str());
        QVERIFY2(made.contains(action), (name + " is not called by this test").c_str());
    }
    QCOMPARE(scopeOf(Action::count, ActorKind::person, {Role::admin}), Scope::none); // no row: denied
    QVERIFY(token(Action::count).empty());
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

namespace {

std::int64_t studyTargetOf(Touches touches, const StudyTargets& study) {
    switch (touches) {
    case Touches::draft:
        return study.draft;
    case Touches::frozen:
    case Touches::keys:
        return study.frozen;
    case Touches::enrolled:
        return study.enrolled;
    case Touches::ready:
        return study.ready;
    case Touches::participant:
        return study.running;
    case Touches::withdrawn:
        return study.withdrawn;
    case Touches::run:
        return study.run;
    default:
        return 0;
    }
}

} // namespace

std::int64_t TestAccess::targetOf(Action action, const Call& call, const Who& who, Whose whose) const {
    const Who& simulated = m_people[1];
    const Who& owner = whose == Whose::own ? who : whose == Whose::simulated ? simulated : m_bob;
    switch (call.touches) {
    case Touches::nothing:
        return -1;
    case Touches::person:
        // What only administrators do to others is tried on somebody without a running session.
        return whose == Whose::other && action != Action::exportPerson ? m_world.eve : owner.actor.personId();
    case Touches::running:
        return owner.running;
    case Touches::ended:
        return owner.ended;
    default:
        return studyTargetOf(call.touches, whose == Whose::other ? m_ruth.study : owner.study);
    }
}

void TestAccess::functionsDoAsTheTableSays() {
    QFETCH(int, action);
    const auto what = static_cast<Action>(action);
    const auto made = accessCalls(m_world);
    const Call& call = made.at(what);
    for (const Who& who : m_people) {
        const Scope scope = scopeOf(what, who.kind, who.roles);
        std::vector<Whose> cases{Whose::other};
        const bool ofStudy = call.touches >= Touches::draft;
        if (call.touches != Touches::nothing && who.actor.personId() != 0 &&
            (!ofStudy || who.study.frozen != 0) &&
            !(call.touches == Touches::withdrawn && who.kind == ActorKind::simulated)) {
            cases.push_back(Whose::own);
        }
        if (call.touches == Touches::ended || call.touches == Touches::running ||
            (ofStudy && call.touches != Touches::withdrawn && call.touches != Touches::keys)) {
            cases.push_back(Whose::simulated);
        }
        for (const Whose whose : cases) {
            const bool isOwn =
                whose == Whose::own || (whose == Whose::simulated && who.kind == ActorKind::simulated);
            const bool isSimulated = whose == Whose::simulated || (isOwn && who.kind == ActorKind::simulated);
            const bool expected =
                call.touches == Touches::nothing
                    ? scope != Scope::none
                    : scope == Scope::all ||
                          (isOwn && (scope == Scope::own || scope == Scope::ownAndSimulated)) ||
                          (isSimulated && (scope == Scope::simulated || scope == Scope::ownAndSimulated));
            const auto outcome = perform(call, who.actor, targetOf(what, call, who, whose));
            const QString place =
                who.title +
                (isOwn         ? " own"
                 : isSimulated ? " simulated"
                               : " other") +
                ": " + (outcome ? QStringLiteral("done") : QString::fromStdString(outcome.error().message));
            if (expected) {
                // Passing the check is not enough: it must work, unless a rule of its own forbids it
                // (oneself).
                const bool oneself = isOwn && who.roles.contains(Role::admin) && !outcome &&
                                     outcome.error().code == core::ErrorCode::wrongUse;
                QVERIFY2(outcome || oneself, qPrintable(place));
            } else {
                QVERIFY2(!outcome && outcome.error().code == core::ErrorCode::notAllowed, qPrintable(place));
            }
        }
    }
}

void TestAccess::writesBelongToAJob_data() {
    QTest::addColumn<int>("action");
    // These also work beside a writer, have a refusal of their own there, or answer it like a permission.
    const std::set<Action> others{Action::beginLogin, Action::finishLogin, Action::beginRecovery,
                                  Action::setBackupPlan, Action::createFirstAdministrator};
    for (const auto& [action, call] : accessCalls(m_world)) {
        if (call.inJob && !others.contains(action)) {
            QTest::newRow(std::string(token(action)).c_str()) << static_cast<int>(action);
        }
    }
}

// A function that writes refuses a reader's connection, and the writer's own outside of a transaction, where
// what it did before it failed would stay. It does so before it looks at anything else.
void TestAccess::writesBelongToAJob() {
    QFETCH(int, action);
    const auto what = static_cast<Action>(action);
    const auto made = accessCalls(m_world);
    const Call& call = made.at(what);
    const Actor admin = m_people.back().actor;
    auto reader = m.database->openReader();
    REQUIRE(reader);
    const auto beside = call.run(**reader, admin, 0);
    QVERIFY(!beside);
    QCOMPARE(beside.error().code, core::ErrorCode::wrongUse);
    if (what == Action::openSink) {
        return; // a recording has transactions of its own
    }
    const auto outside = m.database->writer().runMaintenance(
        [&](WriteContext& w) { return call.run(w.connection(), admin, 0); });
    QVERIFY(!outside);
    QCOMPARE(outside.error().code, core::ErrorCode::wrongUse);
}

void TestAccess::disabledAndForcedAccountsMayNothing() {
    const Actor admin = m_people.back().actor;
    const auto zoe = m.person(admin, "zoe", {Role::admin});
    REQUIRE(zoe);
    AccountService accounts(*m.database);
    REQUIRE(accounts.listPeople(*zoe));
    REQUIRE(accounts.resetPassword(admin, zoe->personId(), "another horse 7"));
    QCOMPARE(accounts.listPeople(*zoe).error().code,
             core::ErrorCode::notAllowed); // an actor from before the reset
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
            QVERIFY2(scope == Scope::all || (own && scope == Scope::ownAndSimulated) ||
                         (simulated && scope != Scope::own),
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
