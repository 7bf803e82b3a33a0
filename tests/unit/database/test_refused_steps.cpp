// SPDX-License-Identifier: GPL-3.0-or-later
#include "access_calls.h"
#include "study_site.h"

#include "database/access/authorise.h"
#include "support/refusing_opened.h"

#include <QDir>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <algorithm>
#include <atomic>
#include <sqlite3.h>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

/// Makes SQLite refuse one step on a connection, and counts the steps. A step is a statement, refused when it
/// is prepared, or an instruction, at which the running statement is interrupted.
class Refusing {
public:
    enum class What { statement, running };

    /// `which`: the number of the step to refuse, from 1; 0 refuses none.
    Refusing(Connection& connection, What what, int which) : m_handle(connection.handle()), m_which(which) {
        if (what == What::statement)
            sqlite3_set_authorizer(
                m_handle,
                [](void* self, int action, const char*, const char*, const char*, const char*) {
                    const bool begins = action == SQLITE_SELECT || action == SQLITE_INSERT ||
                                        action == SQLITE_UPDATE || action == SQLITE_DELETE;
                    return begins && static_cast<Refusing*>(self)->refuses() ? SQLITE_DENY : SQLITE_OK;
                },
                this);
        else
            sqlite3_progress_handler(
                m_handle, 1, [](void* self) { return static_cast<Refusing*>(self)->refuses() ? 1 : 0; },
                this);
    }
    ~Refusing() {
        sqlite3_set_authorizer(m_handle, nullptr, nullptr);
        sqlite3_progress_handler(m_handle, 0, nullptr, nullptr);
    }
    Refusing(const Refusing&) = delete;
    Refusing& operator=(const Refusing&) = delete;

    int seen() const { return m_seen; }

private:
    bool refuses() { return ++m_seen == m_which; }

    sqlite3* m_handle;
    int m_which;
    int m_seen = 0;
};

struct Tried {
    core::Result<void> outcome;
    int steps = 0; ///< that were taken, the refused one included
};

} // namespace

/// A full or failing disk can refuse any statement. Whichever it is, the function that needed it returns an
/// error and does not go on without the data.
class TestRefusedSteps : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void everyRefusedStepIsTold_data();
    void everyRefusedStepIsTold();
    void upkeepLeavesNothingHalfDone_data();
    void upkeepLeavesNothingHalfDone();

private:
    Tried attempt(const Call& call, const Actor& actor, std::int64_t target, Refusing::What what, int which);
    std::vector<std::int64_t> targets(Touches touches) const;

    CallWorld m_world;
    DatabaseFixture& m = m_world.fixture;
    std::vector<Actor> m_actors; ///< who may do something that the others may not
    PersonId m_bob = 0;
    PersonId m_ada = 0; ///< the administrator
    SessionId m_running = 0;
    SessionId m_ended = 0;
    StudyTargets m_study{};
};

void TestRefusedSteps::initTestCase() {
    REQUIRE(m.create());
    const auto admin = m.administrator();
    REQUIRE(admin);
    const auto bob = m.person(*admin, "bob", {Role::trainee});
    const auto eve = m.person(*admin, "eve", {Role::trainee});
    const auto ruth = m.person(*admin, "ruth", {Role::researcher});
    REQUIRE(bob);
    REQUIRE(eve);
    REQUIRE(ruth);
    m_bob = bob->personId();
    m_ada = admin->personId();
    m_world.eve = eve->personId();
    const auto ended = storeSession(*m.database, *bob);
    REQUIRE(ended);
    m_ended = *ended;
    const auto running = m.database->write(
        [&](WriteContext& w) { return SessionRepository(w.connection(), *bob).beginSession(someSession()); });
    REQUIRE(running);
    m_running = *running;
    const auto study = makeStudies(*m.database, *ruth, "simulated");
    REQUIRE(study);
    m_study = *study;
    m_actors = {*admin, *bob, *ruth, Actor::maintenance(), Actor::simulated(), Actor::anonymous()};
    m_world.backup = m.path("backup");
    REQUIRE(Upkeep::backup(*m.database, *admin, m_world.backup));
}

void TestRefusedSteps::everyRefusedStepIsTold_data() {
    QTest::addColumn<int>("action");
    for (int i = 0; i < static_cast<int>(Action::count); ++i)
        QTest::newRow(std::string(token(static_cast<Action>(i))).c_str()) << i;
}

Tried TestRefusedSteps::attempt(const Call& call, const Actor& actor, std::int64_t target,
                                Refusing::What what, int which) {
    Tried tried;
    const auto run = [&](Connection& connection) {
        Refusing refusing(connection, what, which);
        tried.outcome = call.run(connection, actor, target);
        tried.steps = refusing.seen();
    };
    if (call.inJob) {
        (void)m.database->write([&](WriteContext& w) -> core::Result<void> {
            run(w.connection());
            return core::fail(core::ErrorCode::cancelled, "undone");
        });
    } else if (auto reader = m.database->openReader()) {
        run(**reader);
    }
    return tried;
}

std::vector<std::int64_t> TestRefusedSteps::targets(Touches touches) const {
    switch (touches) {
    case Touches::nothing:
        return {-1};
    case Touches::person:
        return {m_world.eve, m_bob, m_ada};
    case Touches::running:
        return {m_running};
    case Touches::ended:
        return {m_ended};
    case Touches::draft:
        return {m_study.draft};
    case Touches::frozen:
    case Touches::keys:
        return {m_study.frozen};
    case Touches::enrolled:
        return {m_study.enrolled};
    case Touches::ready:
        return {m_study.ready};
    case Touches::participant:
        return {m_study.running};
    case Touches::withdrawn:
        return {m_study.withdrawn};
    case Touches::run:
        return {m_study.run};
    }
    return {};
}

void TestRefusedSteps::everyRefusedStepIsTold() {
    QFETCH(int, action);
    const auto what = static_cast<Action>(action);
    const auto made = accessCalls(m_world);
    const Call& call = made.at(what);
    constexpr int kMost = 60; // of many steps, about so many are tried, evenly spaced
    const bool opensItsOwn = what == Action::backup || what == Action::dailyBackup ||
                             what == Action::exportSite ||
                             what == Action::restore; // upkeepLeavesNothingHalfDone()
    for (const Actor& actor : m_actors)
        for (const std::int64_t target : targets(call.touches)) {
            if (!attempt(call, actor, target, Refusing::What::statement, 0).outcome)
                continue; // not this one's to do
            for (const auto kind : {Refusing::What::statement, Refusing::What::running}) {
                const int steps = attempt(call, actor, target, kind, 0).steps;
                QVERIFY(steps > 0 || opensItsOwn);
                const int stride = std::max(1, steps / kMost);
                for (int which = 1; which <= steps; which += stride) {
                    const Tried tried = attempt(call, actor, target, kind, which);
                    if (tried.steps >= which)
                        QVERIFY2(!tried.outcome,
                                 qPrintable(
                                     QStringLiteral("%1 %2 of %3 was refused, and nothing was said")
                                         .arg(kind == Refusing::What::statement ? "statement" : "instruction")
                                         .arg(which)
                                         .arg(steps)));
                }
            }
            return;
        }
    QFAIL("nobody may do this here");
}

void TestRefusedSteps::upkeepLeavesNothingHalfDone_data() {
    QTest::addColumn<int>("action");
    for (const Action action : {Action::backup, Action::exportSite, Action::restore})
        QTest::newRow(std::string(token(action)).c_str()) << static_cast<int>(action);
}

// These open their own connections and write files.
void TestRefusedSteps::upkeepLeavesNothingHalfDone() {
    QFETCH(int, action);
    const auto made = accessCalls(m_world);
    const Call& call = made.at(static_cast<Action>(action));
    const auto reader = m.database->openReader();
    REQUIRE(reader);
    const QDir folder(QString::fromStdString(m.path("")));
    const auto files = [&] {
        return folder.entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden);
    };
    const auto newFiles = [&](const QStringList& before) { // without the number of the attempt
        QStringList fresh;
        for (const QString& name : files()) {
            if (before.contains(name))
                continue;
            static const QRegularExpression number(QStringLiteral("[0-9]+"));
            const QString plain = QString(name).replace(number, QString());
            fresh << plain;
            for (const QFileInfo& inner : QDir(folder.filePath(name)).entryInfoList(QDir::Files, QDir::Name))
                fresh << plain + QLatin1Char('/') + inner.fileName();
        }
        return fresh;
    };
    int steps = 0;
    QStringList whole;
    {
        const QStringList before = files();
        const tests::RefusingAllOpened refusing(0);
        REQUIRE(call.run(**reader, m_actors.front(), -1));
        steps = refusing.seen();
        whole = newFiles(before);
    }
    QVERIFY(steps > 10);
    constexpr int kEvery = 5; // all of them take 25 s; the first is drawn
    const int first = 1 + static_cast<int>(QRandomGenerator::global()->bounded(kEvery));
    qInfo("every %dth statement from %d on", kEvery, first);
    for (int which = first; which <= steps; which += kEvery) {
        const QStringList before = files();
        const tests::RefusingAllOpened refusing(which);
        const auto outcome = call.run(**reader, m_actors.front(), -1);
        if (refusing.seen() < which)
            continue;
        const QString place = QStringLiteral("statement %1 of %2 was refused; left: ").arg(which).arg(steps);
        if (outcome) // without what was refused, the check of a copy only looks into more tables than it has
                     // to
            QVERIFY2(newFiles(before) == whole, qPrintable(place + newFiles(before).join(QLatin1Char(' '))));
        else
            QVERIFY2(files() == before, qPrintable(place + newFiles(before).join(QLatin1Char(' '))));
    }
}

QTEST_GUILESS_MAIN(TestRefusedSteps)
#include "test_refused_steps.moc"
