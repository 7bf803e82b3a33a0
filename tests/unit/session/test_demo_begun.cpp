// SPDX-License-Identifier: GPL-3.0-or-later
// The making of a demonstration as far as it takes a moment: who is there, what is planned, and that a
// broken-off one leaves nothing (the whole of it is test_demo_study's).
#include "catalogue/catalogue.h"
#include "database/accounts/account_service.h"
#include "database/repositories/study_reader.h"
#include "session/demo_site.h"
#include "support/session_fixture.h"

#include <QDir>
#include <QFileInfo>
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <set>
#include <tuple>

using namespace chiron;

namespace {

const catalogue::Catalogue& content() {
    static const auto loaded = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!loaded)
        qFatal("%s", loaded.error().message.c_str());
    return *loaded;
}

/// Sessions of operators on every level but the later ones of palpation, then what three trainees have tried:
/// one can do it, two learn.
int plannedSessions() {
    int count = 0;
    for (const catalogue::Exercise& exercise : content().exercises()) {
        const std::vector<std::string> names = (*session::exerciseKind(exercise.id))->operatorNames();
        for (const catalogue::ExerciseLevel& level : exercise.levels) {
            count += exercise.id != "palpation" || level.number <= 2 ? static_cast<int>(names.size()) : 0;
            const bool organs = (exercise.id == "sphere_apex" && level.number >= 5) ||
                                (exercise.id == "elastic_tube" && level.number == 4);
            const bool learned = exercise.id == "sphere_apex" || exercise.id == "elastic_tube";
            count += level.number <= 2 || organs ? 1 : 0; // Eva
            if (learned && level.number == 1)
                count += 4 + 5; // Nikos and Ines
            else if (learned ? level.number == 2 : level.number == 1 && exercise.id != "palpation")
                count += 2;
        }
    }
    return count;
}

database::DatabaseOptions cheap() {
    database::DatabaseOptions options;
    options.passwordCost = database::PasswordCost::minimalForTests();
    return options;
}

} // namespace

class TestDemoBegun : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("CHIRON_CONTENT", CHIRON_SOURCE_DIR "/curriculum/content"); }
    void thePeopleOfTheSite();
    void aBrokenOffSiteLeavesNothing();
    void whatWasThereStays();
    void quickRunsOfItsStudy();
    void anythingThatDiffersIsFound();
};

void TestDemoBegun::thePeopleOfTheSite() {
    tests::SessionFixture fixture;
    std::atomic<bool> cancel{false};
    std::vector<session::DemoProgress> told;
    const auto stopped = session::makeDemoSite(
        *fixture.database, content(), 3,
        [&](const session::DemoProgress& progress) {
            told.push_back(progress);
            cancel = true;
        },
        &cancel);
    QVERIFY(!stopped && stopped.error().code == core::ErrorCode::cancelled);
    QCOMPARE(told.size(), std::size_t{1});
    QCOMPARE(told.front().step, 1);
    QCOMPARE(told.front().of, plannedSessions() + session::demoStudyParticipants());
    const catalogue::Exercise& first = content().exercises().front();
    QCOMPARE(told.front().doing,
             first.id + " level 1, " + (*session::exerciseKind(first.id))->operatorNames().front());
    database::AccountService accounts(*fixture.database);
    const auto admin = accounts.login("amalia", session::kDemoPassword);
    QVERIFY(admin.has_value());
    QVERIFY(admin->roles() == database::RoleSet{database::Role::admin});
    const auto people = accounts.listPeople(*admin);
    QVERIFY(people && people->size() == 6);
    using database::Role;
    for (const auto& [name, display, role] : {std::tuple{"theo", "Theo Trainer", Role::trainer},
                                              {session::kDemoResearcher, "Rhea Researcher", Role::researcher},
                                              {"nikos", "Nikos Newcomer", Role::trainee},
                                              {"ines", "Ines Improving", Role::trainee},
                                              {"eva", "Eva Expert", Role::trainee}}) {
        const auto person = accounts.personByName(*admin, name);
        QVERIFY2(person && person->displayName == display && person->roles == database::RoleSet{role} &&
                     person->enabled && !person->mustChangePassword,
                 name);
        QVERIFY2(accounts.login(name, session::kDemoPassword), name);
    }
}

void TestDemoBegun::aBrokenOffSiteLeavesNothing() {
    QTemporaryDir folder;
    for (const bool siteIsThere : {false, true}) {
        const QString file = folder.filePath(siteIsThere ? QStringLiteral("b.db") : QStringLiteral("a.db"));
        database::DatabaseOptions options = cheap();
        if (siteIsThere) {
            options.siteFolder = folder.filePath(QStringLiteral("site")).toStdString();
            QVERIFY(QDir().mkpath(folder.filePath(QStringLiteral("site"))));
        }
        std::atomic<bool> cancel{false};
        const auto stopped = session::createDemoSite(
            file.toStdString(), options, content(), 3,
            [&](const session::DemoProgress&) {
                QVERIFY(QFileInfo::exists(file));
                cancel = true;
            },
            &cancel);
        QVERIFY(!stopped && stopped.error().code == core::ErrorCode::cancelled);
        QCOMPARE(QDir(folder.path())
                     .entryList({siteIsThere ? QStringLiteral("b.db*") : QStringLiteral("a.db*")},
                                QDir::AllEntries),
                 QStringList());
        QCOMPARE(QFileInfo::exists(folder.filePath(QStringLiteral("site"))),
                 siteIsThere); // what was not made here is left
    }
}

void TestDemoBegun::whatWasThereStays() {
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("mine.db")));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
    file.close();
    const auto refused = session::createDemoSite(file.fileName().toStdString(), cheap(), content(), 3,
                                                 [](const session::DemoProgress&) { QFAIL("begun"); });
    QVERIFY(!refused && refused.error().code == core::ErrorCode::badInput);
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
             QStringList{QStringLiteral("mine.db")});
    QCOMPARE(file.size(), 4);
}

// Everybody but the last goes without rendering; stopped before that one, what they did is there.
void TestDemoBegun::quickRunsOfItsStudy() {
    tests::SessionFixture fixture;
    database::AccountService accounts(*fixture.database);
    QVERIFY(accounts.createFirstAdministrator("ada", session::kDemoPassword, "Ada").has_value());
    const auto ada = accounts.login("ada", session::kDemoPassword);
    std::atomic<bool> cancel{false};
    std::vector<std::string> told;
    const auto stopped = session::makeDemoStudy(
        *fixture.database, *ada, 5,
        [&](const std::string& doing) {
            told.push_back(doing);
            cancel = !doing.ends_with(", without rendering");
        },
        &cancel);
    QVERIFY(!stopped && stopped.error().code == core::ErrorCode::cancelled);
    QCOMPARE(told.size(), static_cast<std::size_t>(session::demoStudyParticipants()));
    QCOMPARE(told.front(), std::string("study stiffness_elastic_tube, SIM-1, without rendering"));
    QCOMPARE(told.back(), std::string("study stiffness_elastic_tube, SIM-7"));
    auto connection = fixture.database->openReader();
    database::StudyReader reader(**connection, *ada);
    const auto studies = reader.listStudies();
    QVERIFY(studies && studies->size() == 2);
    QVERIFY(studies->front().key == "stiffness_elastic_tube" &&
            studies->front().state == database::StudyState::frozen && studies->front().participants == 7);
    QVERIFY(studies->back().key == "surgeons" && studies->back().state == database::StudyState::draft);
    const auto participants = reader.participants(studies->front().id);
    QVERIFY(participants && participants->size() == 7);
    std::set<std::string> observers;
    for (std::size_t i = 0; i < 7; ++i) {
        const database::Participant& who = participants->at(i);
        QCOMPARE(who.code, "SIM-" + std::to_string(i + 1));
        observers.insert(who.observer);
        const auto runs = reader.runs(who.id);
        QVERIFY(runs.has_value());
        if (i == 6) {
            QVERIFY(who.state != database::ParticipantState::completed);
            continue;
        }
        QVERIFY(who.state == database::ParticipantState::completed && runs->size() == 1);
        const auto trials = reader.studyTrials(runs->front().id);
        QVERIFY(trials && trials->size() > 20);
        for (const database::StudyTrial& trial : *trials)
            QCOMPARE(trial.session, database::SessionId{0});
    }
    QCOMPARE(observers.size(), std::size_t{6}); // two are alike: one with rendering, one without
}

/// Whatever it is, and whichever of several.
void TestDemoBegun::anythingThatDiffersIsFound() {
    session::DemoSite good;
    good.sessions.resize(3);
    for (session::DemoResult& each : good.sessions)
        each.replayIdentical = each.scoreSame = true;
    good.study.runs.resize(2);
    for (session::DemoStudyRun& each : good.study.runs)
        each.choicesSame = true;
    good.study.replayIdentical = true;
    QVERIFY(good.holds());
    good.study.replayIdentical = false;
    QVERIFY(!good.holds());
    good.study.replayIdentical = true;
    for (session::DemoResult& each : good.sessions)
        for (bool session::DemoResult::*what :
             {&session::DemoResult::replayIdentical, &session::DemoResult::scoreSame}) {
            each.*what = false;
            QVERIFY(!good.holds());
            each.*what = true;
        }
    for (session::DemoStudyRun& each : good.study.runs) {
        each.choicesSame = false;
        QVERIFY(!good.holds());
        each.choicesSame = true;
    }
    QVERIFY(good.holds());
}

QTEST_GUILESS_MAIN(TestDemoBegun)
#include "test_demo_begun.moc"
