// SPDX-License-Identifier: GPL-3.0-or-later
// What was run of the ladder is kept, comes back as it was, and is not run again; and what the passivity
// controller does is judged by what the level's scene says of its law.
#include "ladder/ladder.h"
#include "ladder/ladder_store.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

using namespace chiron;
using tests::LadderLevel;
using tests::LadderSession;
using tests::LadderSettings;
using tests::LadderStore;

namespace {

LadderSession someSession(std::uint64_t seed) {
    LadderSession session;
    session.seed = seed;
    session.completed = true;
    session.card.passed = true;
    session.card.metrics.resize(2);
    session.card.metrics[0].id = "time";
    session.card.metrics[0].version = 3;
    session.card.metrics[0].value = 1.0 / 3.0;
    session.card.metrics[1].id = "drops";
    session.card.metrics[1].passed = false; // and no value
    session.ticks = 5;
    session.acted = 6;
    session.kept_J = -0.125;
    session.withheld_J = 0.25;
    session.heldBeyond_J = 0.5;
    session.tissue_N = 7.0;
    session.commanded_N = 8.0;
    session.fast_N = 0.0625;
    session.fastEnds_s = 9.5;
    session.windows = 10;
    session.replaysIdentically = true;
    return session;
}

} // namespace

class TestLadderStore : public QObject {
    Q_OBJECT
private slots:
    void sessionsComeBackAsTheyWere();
    void otherSourcesAndSettingsAreLeftAlone();
    void aLineThatWasCutOffSpoilsNoOther();
    void whatIsKeptIsNotRunAgain();
    void theControllerIsJudgedByTheLaw();

private:
    const catalogue::ExerciseLevel& level() const { return *m_catalogue.find("urethra_insertion", 1); }
    std::string folder() const { return m_folder.path().toStdString(); }

    QTemporaryDir m_folder;
    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
};

void TestLadderStore::sessionsComeBackAsTheyWere() {
    LadderStore store(folder(), {"a", "1"});
    QVERIFY(store.sessions(level(), "expert", {}).empty());
    store.add(level(), "expert", {}, someSession(18446744073709551615ull));
    LadderSession again = someSession(3);
    again.checked = again.scoresIdentically = true;
    store.add(level(), "expert", {}, someSession(3));
    store.add(level(), "expert", {}, again); // the later one counts
    const auto found = LadderStore(folder(), {"a", "1"}).sessions(level(), "expert", {});
    QCOMPARE(found.size(), std::size_t{2});
    const LadderSession &first = found[0], was = someSession(0);
    QCOMPARE(first.seed, 18446744073709551615ull);
    QVERIFY(first.completed && first.card.passed && first.card.metrics.size() == 2);
    QVERIFY(first.card.metrics[0].id == "time" && first.card.metrics[0].version == 3 &&
            first.card.metrics[0].value == 1.0 / 3.0 && !first.card.metrics[0].passed);
    QVERIFY(first.card.metrics[1].id == "drops" && !first.card.metrics[1].value &&
            first.card.metrics[1].passed == false);
    QVERIFY(first.ticks == was.ticks && first.acted == was.acted && first.kept_J == was.kept_J &&
            first.withheld_J == was.withheld_J && first.heldBeyond_J == was.heldBeyond_J);
    QVERIFY(first.tissue_N == was.tissue_N && first.commanded_N == was.commanded_N &&
            first.fast_N == was.fast_N && first.fastEnds_s == was.fastEnds_s && first.windows == was.windows);
    QVERIFY(!first.checked && first.replaysIdentically && !first.scoresIdentically);
    QVERIFY(found[1].checked && found[1].scoresIdentically);
}

void TestLadderStore::otherSourcesAndSettingsAreLeftAlone() {
    QTemporaryDir own;
    const std::string place = own.path().toStdString();
    QVERIFY(!LadderStore::last(place, level()));
    LadderStore store(place, {"a", "1"});
    store.add(level(), "expert", {}, someSession(3));
    QVERIFY(LadderStore(place, {"b", "1"}).sessions(level(), "expert", {}).empty());
    QVERIFY(LadderStore(place, {"a", "2"}).sessions(level(), "expert", {}).empty());
    QVERIFY(store.sessions(level(), "novice", {}).empty());
    QVERIFY(store.sessions(*m_catalogue.find("urethra_insertion", 2), "expert", {}).empty());
    for (const auto change : {+[](LadderSettings& s) { s.hand = "firm"; },
                              +[](LadderSettings& s) { s.mechanism = "gimbal_hprd"; },
                              +[](LadderSettings& s) { s.budget_Ns_per_m = 50.0; }}) {
        LadderSettings other;
        change(other);
        QVERIFY(store.sessions(level(), "expert", other).empty());
    }
    QCOMPARE(store.sessions(level(), "expert", {}).size(), std::size_t{1});
    LadderStore(place, {"b", "2"}).add(level(), "expert", {}, someSession(4));
    QVERIFY(LadderStore::last(place, level()) == (LadderStore::Sources{"b", "2"}));
    QVERIFY(!LadderStore::present().models.empty());
}

void TestLadderStore::aLineThatWasCutOffSpoilsNoOther() {
    QTemporaryDir own;
    LadderStore store(own.path().toStdString(), {"a", "1"});
    store.add(level(), "expert", {}, someSession(3));
    store.add(level(), "expert", {}, someSession(4));
    QFile file(own.filePath(QStringLiteral("urethra_insertion_1.jsonl")));
    QVERIFY(file.resize(file.size() - 20)); // killed while it was written
    store.add(level(), "expert", {}, someSession(5));
    const auto found = store.sessions(level(), "expert", {});
    QCOMPARE(found.size(), std::size_t{2});
    QVERIFY(found[0].seed == 3 && found[1].seed == 5);
}

void TestLadderStore::whatIsKeptIsNotRunAgain() {
    QTemporaryDir own;
    LadderStore store(own.path().toStdString());
    LadderSettings settings;
    settings.operators = {"expert"};
    settings.seeds = 2;
    settings.first = 50;
    settings.checkEvery = 0;
    settings.store = &store;
    store.add(level(), "expert", settings, someSession(3)); // 7 N, that nobody felt
    const LadderLevel climbed = tests::climb(level(), settings);
    const auto& sessions = climbed.byOperator.at("expert");
    QCOMPARE(sessions.size(), std::size_t{2});
    QVERIFY(sessions[0].seed == 3 && sessions[0].tissue_N == 7.0);
    QVERIFY(sessions[1].seed == 50 && sessions[1].tissue_N > 0.0 && sessions[1].tissue_N != 7.0);
    QCOMPARE(tests::recalled(level(), settings).byOperator.at("expert").size(), std::size_t{2});
    settings.checkEvery = 1; // what was not replayed is run for it
    const auto checked = tests::climb(level(), settings).byOperator.at("expert");
    QVERIFY(checked[0].checked && checked[0].tissue_N != 7.0 && checked[1].checked);
}

void TestLadderStore::theControllerIsJudgedByTheLaw() {
    QVERIFY(tests::lawOf(level()).conservative && !tests::lawOf(level()).softens);
    const tests::LadderLaw tube = tests::lawOf(*m_catalogue.find("elastic_tube", 3));
    QVERIFY(tube.conservative && tube.softens);
    QVERIFY(!tests::lawOf(*m_catalogue.find("sphere_apex", 5)).conservative);
    LadderLevel climbed;
    LadderSession session; // with nothing
    session.heldBeyond_J = 0.0024;
    climbed.byOperator["unsafe"] = {session};
    climbed.law = {true, false};
    QCOMPARE(tests::unfounded(climbed).size(), std::size_t{0});
    climbed.byOperator["unsafe"][0].acted = 1;
    QCOMPARE(tests::unfounded(climbed).size(), std::size_t{1});
    climbed.law = {false, false};
    QCOMPARE(tests::unfounded(climbed).size(), std::size_t{0});
    climbed.law = {true, true}; // softened, because samples might be late
    QCOMPARE(tests::unfounded(climbed).size(), std::size_t{0});
    climbed.byOperator["unsafe"][0].heldBeyond_J = 0.0026;
    QCOMPARE(tests::unfounded(climbed).size(), std::size_t{1});
}

QTEST_GUILESS_MAIN(TestLadderStore)
#include "test_ladder_store.moc"
