// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/upkeep/upkeep.h"
#include "desktop/station/station_words.h"
#include "desktop/storage/storage_words.h"
#include "realtime/virtual_clock.h"
#include "session/backup_list.h"
#include "session/group_standing.h"
#include "session/integrity_check.h"
#include "session/level_standing.h"
#include "session/loop_self_test.h"
#include "support/desktop_fixture.h"

#include <QDir>
#include <algorithm>
#include <tuple>

using namespace chiron;
using namespace chiron::desktop;
using database::SessionState;

namespace {

database::SessionSummary attempt(database::SessionId id, int level, SessionState state,
                                 std::optional<bool> passed, bool felt = true) {
    database::SessionSummary session;
    session.id = id;
    session.exercise = "sphere_apex";
    session.level = level;
    session.state = state;
    session.passed = passed;
    session.felt = felt;
    return session;
}

/// Late by 300 µs at every hundredth tick.
struct LateClock {
    realtime::VirtualClock clock;
    int ticks = 0;
    std::int64_t now_ns() const noexcept { return clock.now_ns(); }
    void waitUntil(std::int64_t deadline_ns) noexcept {
        if (++ticks % 100 == 0)
            clock.delayNextWake(300'000);
        clock.waitUntil(deadline_ns);
    }
};

} // namespace

/// What the screens of lists and upkeep are made of, without a window.
class TestListsRules : public QObject {
    Q_OBJECT
private slots:
    void standingsCountWhatCounts() {
        const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        QVERIFY(catalogue);
        std::vector<database::SessionSummary> own;
        auto fresh = session::levelStandings(*catalogue, own);
        std::size_t levels = 0;
        for (const auto& exercise : catalogue->exercises())
            levels += exercise.levels.size();
        QCOMPARE(fresh.size(), levels);
        QCOMPARE(session::nextStep(fresh)->level, 1);
        QVERIFY(fresh[0].standing() == session::Standing::fresh);

        own.push_back(attempt(1, 1, SessionState::completed, true));
        own.push_back(attempt(2, 2, SessionState::completed, false, false));
        auto voided = attempt(3, 3, SessionState::voided, true);
        auto practice = attempt(4, 4, SessionState::completed, true);
        practice.familiarisation = true;
        auto script = attempt(5, 3, SessionState::completed, true);
        script.operatorName = "expert";
        own.insert(own.end(), {voided, practice, script});
        const auto standings = session::levelStandings(*catalogue, own);
        QVERIFY(standings[0].passedFelt && !standings[0].passedShown);
        QVERIFY(standings[1].standing() == session::Standing::tried);
        QVERIFY(standings[2].standing() == session::Standing::fresh); // voided, and a script's hand
        QVERIFY(standings[3].standing() == session::Standing::fresh); // familiarisation
        QCOMPARE(session::nextStep(standings)->level, 2);

        script.demonstration = true; // on a demonstration site scripts stand in for people
        own.push_back(script);
        QVERIFY(session::levelStandings(*catalogue, own)[2].passedFelt);
        own.push_back(attempt(6, 3, SessionState::stopped, true));
        QCOMPARE(session::nextStep(session::levelStandings(*catalogue, own))->level, 2);
    }

    void aGroupIsTheTraineesAndWhoeverTrained() {
        const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        QVERIFY(catalogue);
        using enum database::Role;
        std::vector<database::Person> people(5);
        const std::vector<std::tuple<const char*, const char*, database::RoleSet, bool>> given{
            {"tina", "Tina T.", {trainee}, true},
            {"theo", "", {trainee}, true},
            {"gone", "", {trainee}, false},
            {"tom", "Tom", {trainer}, true},
            {"rhea", "", {researcher}, true}};
        for (std::size_t i = 0; i < people.size(); ++i) {
            people[i].id = static_cast<database::PersonId>(i) + 2;
            std::tie(people[i].name, people[i].displayName, people[i].roles, people[i].enabled) = given[i];
        }
        const auto by = [](database::PersonId person, database::SessionSummary session) {
            session.person = person;
            return session;
        };
        std::vector<database::SessionSummary> sessions{by(2, attempt(1, 1, SessionState::completed, true)),
                                                       by(2, attempt(3, 2, SessionState::completed, false)),
                                                       by(5, attempt(4, 1, SessionState::stopped, {})),
                                                       by(4, attempt(5, 1, SessionState::completed, true))};
        sessions[1].toReview = true;
        auto study = by(6, attempt(6, 1, SessionState::completed, true));
        study.ofStudy = true;
        sessions.push_back(study);
        const auto group = session::groupStandings(*catalogue, people, sessions);
        QStringList names;
        for (const session::PersonStanding& person : group)
            names << QString::fromStdString(person.name);
        QCOMPARE(
            names,
            (QStringList{QStringLiteral("Tina T."), QStringLiteral("theo"),
                         QStringLiteral("Tom")})); // not who is disabled, nor who only took part in a study
        const auto& apex = *std::find_if(group[0].exercises.begin(), group[0].exercises.end(),
                                         [](const auto& each) { return each.exercise == "sphere_apex"; });
        QVERIFY(apex.open && apex.open->level == 2 && apex.open->attempts == 1);
        QCOMPARE(apex.attempts, 2);
        QCOMPARE(group[0].exercises.size(), catalogue->exercises().size());
        QVERIFY(group[0].latest && group[0].latest->id == 3);
        QCOMPARE(group[0].toReview, 1);
        QVERIFY(group[0].next && group[0].next->level == 2 && !group[0].allPassed());
        QVERIFY(!group[1].latest && group[1].next && group[1].next->level == 1);
        std::vector<database::SessionSummary> everything;
        for (const catalogue::Exercise& exercise : catalogue->exercises())
            for (const catalogue::ExerciseLevel& level : exercise.levels) {
                everything.push_back(by(3, attempt(static_cast<database::SessionId>(everything.size()) + 1,
                                                   level.number, SessionState::completed, true)));
                everything.back().exercise = exercise.id;
            }
        const auto done = session::groupStandings(*catalogue, people, everything);
        QVERIFY(done[1].allPassed() && std::none_of(done[1].exercises.begin(), done[1].exercises.end(),
                                                    [](const auto& each) { return each.open.has_value(); }));
    }

    void nextStepIsTheLowestOfTheExerciseInHand() {
        std::vector<session::LevelStanding> standings(6);
        for (int i = 0; i < 6; ++i) {
            standings[static_cast<std::size_t>(i)].exercise = i < 3 ? "first" : "second";
            standings[static_cast<std::size_t>(i)].level = i % 3 + 1;
        }
        const auto next = [&] {
            const auto step = session::nextStep(standings);
            return step ? step->exercise + std::to_string(step->level) : std::string();
        };
        QCOMPARE(next(), std::string("first1"));
        standings[5].attempts = 1;
        standings[5].latest = 9;
        QCOMPARE(next(), std::string("second1")); // jumped ahead: the ladder begins below
        standings[3].passedFelt = standings[4].passedShown = true;
        QCOMPARE(next(), std::string("second3"));
        standings[5].passedShown = true;
        QCOMPARE(next(), std::string("first1")); // nothing is left of the exercise in hand
        standings[0].attempts = 1;
        standings[0].latest = 12;
        standings[0].passedFelt = true;
        QCOMPARE(next(), std::string("first2"));
        standings[1].passedFelt = standings[2].passedFelt = true;
        QCOMPARE(next(), std::string());
        QVERIFY(!session::nextStep({}));
    }

    void troubleComesFirst() {
        const int fault = session::attentionRank(attempt(1, 1, SessionState::faulted, {}));
        const int failed = session::attentionRank(attempt(1, 1, SessionState::completed, false));
        const int passed = session::attentionRank(attempt(1, 1, SessionState::completed, true));
        QVERIFY(fault < failed && failed < passed);
        QCOMPARE(session::attentionRank(attempt(1, 1, SessionState::interrupted, {})), fault);
    }

    void roomIsSaidInWords() {
        const QLocale locale(QLocale::English, QLocale::UnitedKingdom);
        session::StorageRoom room{0, 50ULL << 30, 100ULL << 30, 1ULL << 30, 4ULL << 20};
        QVERIFY(StorageWords::room(room, locale).isGood());
        room.diskFree_bytes = session::kLowDisk_bytes - 1;
        QVERIFY(session::diskState(room) == session::RoomState::low);
        QCOMPARE(QLatin1String(StorageWords::room(room, locale).kind), QLatin1String("warning"));
        QVERIFY(StorageWords::room(room, locale)
                    .text.contains(QStringLiteral("2.1 GB"))); // the number with its unit
        room.diskFree_bytes = 1;
        QCOMPARE(QLatin1String(StorageWords::room(room, locale).kind), QLatin1String("bad"));
        room.diskFree_bytes = 50ULL << 30;
        room.ringFree_bytes = room.ringNeeded_bytes - 1;
        QVERIFY(session::ringState(room) == session::RoomState::none);
        QVERIFY(StorageWords::room(room, locale).text.contains(QStringLiteral("cannot start")));
        for (const auto& [free_bytes, state] : {std::pair{room.ringNeeded_bytes, session::RoomState::low},
                                                {2 * room.ringNeeded_bytes, session::RoomState::low},
                                                {4 * room.ringNeeded_bytes - 1, session::RoomState::low},
                                                {4 * room.ringNeeded_bytes, session::RoomState::enough}}) {
            room.ringFree_bytes = free_bytes;
            QVERIFY(session::ringState(room) == state);
        }
    }

    void backupsGrowOld() {
        const QLocale locale(QLocale::English, QLocale::UnitedKingdom);
        const QDateTime now(QDate(2026, 11, 20), QTime(12, 0), Qt::UTC);
        QVERIFY(!StorageWords::backup({}, now, locale).isGood());
        QVERIFY(StorageWords::backup("2026-11-19T12:00:00.000Z", now, locale).isGood());
        QVERIFY(!StorageWords::backup("2026-11-10T12:00:00.000Z", now, locale).isGood());
    }

    void loopReportIsStoredAndReadBack() {
        haptics::LoopStatistics statistics;
        for (int i = 0; i < 990; ++i)
            statistics.add({1'500, 400, 0});
        for (int i = 0; i < 10; ++i)
            statistics.add({300'000, 400, 1});
        session::LoopReport report;
        report.ticks = 1000;
        report.skipped = 10;
        report.passivity_J = 0.0125;
        report.priorityDetail = "no \"priority\"";
        session::setPunctuality(report, statistics);
        QCOMPARE(report.late, std::uint64_t{10});
        QCOMPARE(report.lateness->counts[0], std::uint64_t{990}); // up to 2 µs
        QCOMPARE(report.lateness->counts[7], std::uint64_t{10});  // up to 500 µs
        const auto back = session::loopReportFrom(session::loopJson(report));
        QVERIFY(back);
        QVERIFY(back->lateness == report.lateness);
        QCOMPARE(back->priorityDetail, report.priorityDetail);
        QCOMPARE(back->p50_us, report.p50_us);
        QCOMPARE(back->passivity_J, report.passivity_J);
        QVERIFY(!session::loopReportFrom("[]"));
        const auto old = session::loopReportFrom(
            R"({"ticks":5,"realtime":true,"p50_us":1.5})"); // stored before bins were kept
        QVERIFY(old && !old->lateness && !old->passivity_J && old->p50_us == 1.5);
    }

    void selfTestOnAVirtualClock() {
        LateClock clock;
        session::SelfTestTask task(10'000);
        std::atomic<bool> stop{false};
        const session::LoopReport report = session::runSelfTest(clock, task, stop);
        QCOMPARE(report.ticks, std::uint64_t{10'000});
        QCOMPARE(report.late, std::uint64_t{100});
        QCOMPARE(report.lateness->counts[7], std::uint64_t{100});
        QCOMPARE(report.skipped, std::uint64_t{0});
        QCOMPARE(task.done(), std::uint64_t{10'000});
        QCOMPARE(QLatin1String(StationWords::verdictKind(report)), QLatin1String("warning")); // 1 % late
        stop = true;
        session::SelfTestTask stopped(10'000);
        QCOMPARE(session::runSelfTest(clock, stopped, stop).ticks, std::uint64_t{0});
    }

    void damagedBackupDoesNotVerify() {
        tests::DesktopFixture desktop;
        desktop.addSession("tina", 1, "expert", 1, 1, 5.0);
        const std::string place = (desktop.folder() + QStringLiteral("/copies")).toStdString();
        QDir().mkpath(QString::fromStdString(place));
        QVERIFY(session::listBackups(place).empty());
        QVERIFY(session::listBackups(place + "/nowhere").empty());
        const auto made = database::Upkeep::backup(desktop.database(), desktop.actor("ada"), place + "/one");
        QVERIFY2(made, made ? "" : made.error().message.c_str());
        const auto listed = session::listBackups(place);
        QCOMPARE(listed.size(), std::size_t{1});
        QCOMPARE(listed[0].bytes, made->bytes);
        const std::string site = desktop.file().toStdString();
        QVERIFY(session::verifyBackup(listed[0].folder, site, desktop.options()).ok());
        QFile copy(QString::fromStdString(listed[0].folder + "/chiron.db"));
        QVERIFY(copy.open(QIODevice::ReadWrite));
        QVERIFY(copy.seek(copy.size() / 2));
        QVERIFY(copy.write("damage") == 6);
        copy.close();
        QVERIFY(!session::verifyBackup(listed[0].folder, site, desktop.options()).findings.empty());
    }

    void backupAndVerifyCanBeStopped() {
        tests::DesktopFixture desktop;
        desktop.addSession("tina", 1, "expert", 1, 1, 5.0);
        const std::atomic<bool> stop{true};
        const QString folder = desktop.folder() + QStringLiteral("/stopped");
        const auto made =
            database::Upkeep::backup(desktop.database(), desktop.actor("ada"), folder.toStdString(), &stop);
        QVERIFY(!made && made.error().code == core::ErrorCode::cancelled);
        QVERIFY(!QFileInfo::exists(folder) && !QFileInfo::exists(folder + QStringLiteral(".partial")));
        std::uint64_t of = 0;
        int asked = 0;
        auto report = session::verifyEverything(desktop.file().toStdString(), desktop.options(),
                                                [&](std::uint64_t, std::uint64_t all) {
                                                    of = all;
                                                    return ++asked < 2;
                                                });
        QVERIFY(report.cancelled && !report.ok() && report.findings.empty() && of > 0);
        QCOMPARE(asked, 2); // not asked again once it said stop
        std::uint64_t last = 0;
        report = session::verifyEverything(desktop.file().toStdString(), desktop.options(),
                                           [&](std::uint64_t done, std::uint64_t all) {
                                               of = all;
                                               const bool forward = done >= last && done <= all;
                                               last = done;
                                               return forward;
                                           });
        QVERIFY(report.ok() && last > of / 2);
    }
};

QTEST_MAIN(TestListsRules)
#include "test_lists_rules.moc"
