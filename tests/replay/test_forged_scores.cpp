// SPDX-License-Identifier: GPL-3.0-or-later
// Scores that were stored in due form, digests and all, but are not those of the recording: verify says so.
#include "database/repositories/score_repository.h"
#include "session/integrity_check.h"
#include "support/session_fixture.h"

#include <QtTest>
#include <cmath>
#include <functional>
#include <limits>

using namespace chiron;
using scoring::MetricValue;
using scoring::ScoreCard;
using tests::SessionFixture;
using tests::shortLevel;

Q_DECLARE_METATYPE(std::function<void(ScoreCard&)>)

class TestForgedScores : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void forged_data();
    void forged();
    void trueScoresHold();
    void cleanupTestCase() { m_site.reset(); }

private:
    core::Result<int> store(const ScoreCard& card) {
        return m_site->database->write([&](database::WriteContext& context) {
            return database::ScoreRepository(context.connection(), database::Actor::simulated())
                .storeScores(m_result.session, card);
        });
    }
    std::vector<database::Finding> check() {
        auto connection = m_site->database->openReader();
        return session::checkScores(**connection, m_result.session);
    }
    std::unique_ptr<SessionFixture> m_site;
    session::TrainingResult m_result;
};

void TestForgedScores::initTestCase() {
    m_site = std::make_unique<SessionFixture>();
    auto result = m_site->run(m_site->request(shortLevel(2, 2, 20.0), "expert", 41));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    m_result = std::move(*result);
    QVERIFY(m_result.scores.metrics.front().value && m_result.scores.metrics.front().passed);
    QVERIFY(m_result.scores.trials.size() == 2 && m_result.scores.trials[1].front().value);
}

void TestForgedScores::forged_data() {
    using Forge = std::function<void(ScoreCard&)>;
    QTest::addColumn<Forge>("forge");
    const auto better = [](MetricValue& metric) {
        metric.value = std::nextafter(*metric.value, -std::numeric_limits<double>::infinity());
    };
    QTest::newRow("one last bit") << Forge([=](ScoreCard& card) { better(card.metrics.front()); });
    QTest::newRow("one last bit of a trial")
        << Forge([=](ScoreCard& card) { better(card.trials[1].front()); });
    QTest::newRow("passed") << Forge([](ScoreCard& card) { card.passed = !card.passed; });
    QTest::newRow("a gate") << Forge(
        [](ScoreCard& card) { card.metrics.front().passed = !*card.metrics.front().passed; });
    QTest::newRow("a gate where there is none") << Forge([](ScoreCard& card) {
        for (MetricValue& metric : card.metrics)
            metric.passed = metric.passed.value_or(true);
    });
    QTest::newRow("a version") << Forge([](ScoreCard& card) { ++card.metrics.front().version; });
    QTest::newRow("a unit") << Forge([](ScoreCard& card) { card.metrics.front().unit = "furlong"; });
    QTest::newRow("a metric left out") << Forge([](ScoreCard& card) { card.metrics.pop_back(); });
    QTest::newRow("a trial left out") << Forge([](ScoreCard& card) { card.trials.pop_back(); });
    QTest::newRow("a value withheld") << Forge([](ScoreCard& card) {
        card.metrics.front().value.reset();
        card.metrics.front().reason = "not measured";
    });
    QTest::newRow("another order") << Forge(
        [](ScoreCard& card) { std::swap(card.metrics[0], card.metrics[1]); });
}

void TestForgedScores::forged() {
    QFETCH(std::function<void(ScoreCard&)>, forge);
    ScoreCard card = m_result.scores;
    forge(card);
    const auto stored = store(card);
    QVERIFY2(stored, stored ? "" : stored.error().message.c_str());
    const auto found = check();
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(found.front().kind, std::string("score"));
    QCOMPARE(found.front().row, "session_id=" + std::to_string(m_result.session));
    const auto report = session::verifyEverything(m_site->file());
    QCOMPARE(report.findings.size(), std::size_t{1}); // digests, seals and audit have nothing to say
}

void TestForgedScores::trueScoresHold() {
    QVERIFY(store(m_result.scores));
    QVERIFY(check().empty());
    QVERIFY(session::verifyEverything(m_site->file()).ok());
}

QTEST_GUILESS_MAIN(TestForgedScores)
#include "test_forged_scores.moc"
