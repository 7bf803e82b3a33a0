// SPDX-License-Identifier: GPL-3.0-or-later
// Stored palpations looked back at: the map rebuilt from the recording, the same judgement as the scores, and
// which sessions are pooled for the ROC.
#include "app/exercises/palpation/session/detection_record.h"
#include "app/exercises/palpation/session/palpation_record.h"
#include "support/looked_back.h"
#include "support/made_session.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using tests::OpenStored;
using tests::SessionFixture;

namespace {

constexpr double kCells = 48.0 * 48.0;

/// Hidden single lump, one trial with it and one without, 20 s each.
catalogue::ExerciseLevel twoTrials() {
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    QJsonObject json =
        QJsonDocument::fromJson(QByteArray::fromStdString(catalogue->find("palpation", 2)->resolvedJson))
            .object();
    QJsonObject level = json["level"].toObject();
    QJsonObject parameters = level["parameters"].toObject();
    parameters["trials"] = 2;
    parameters["catch_trials"] = 1;
    parameters["trial_limit_s"] = 20;
    level["parameters"] = parameters;
    json["level"] = level;
    auto changed =
        catalogue::fromResolvedJson(QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString());
    if (!changed)
        qFatal("%s", changed.error().message.c_str());
    return *changed;
}

double sessionValue(const scoring::ScoreCard& card, const std::string& id) {
    for (const scoring::MetricValue& metric : card.metrics)
        if (metric.id == id)
            return metric.value.value_or(std::nan(""));
    return std::nan("");
}

} // namespace

namespace {

core::Result<std::vector<session::PalpationTrialRecord>> recordOf(session::SessionView& view) {
    const auto trace = tests::traceOf(view);
    return trace ? session::palpationRecord(
                       *trace, view.setup().level.parameters.as<simulation::PalpationParameters>())
                 : tl::unexpected(trace.error());
}

} // namespace

class TestPalpationReview : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        auto result = m_site.run(m_site.request(twoTrials(), "expert", 7));
        QVERIFY2(result, result ? "" : result.error().message.c_str());
        m_session = result->session;
        m_scores = result->scores;
    }

    /// The rebuilt map covers what the scene's own did, but for cells at the very edge of the cover force; so
    /// does playback's.
    void mapsComeBack() {
        OpenStored stored(*m_site.database, m_session);
        const auto level = stored.session->setup().level.parameters.as<simulation::PalpationParameters>();
        const auto records = recordOf(*stored.session);
        QVERIFY2(records, records ? "" : records.error().message.c_str());
        QCOMPARE(records->size(), std::size_t{2});
        const auto track = tests::trackOf(*stored.session);
        QVERIFY(track);
        for (const session::PalpationTrialRecord& record : *records) {
            QVERIFY2(record.coverage > 0.05, qPrintable(QString::number(record.coverage)));
            const double difference = (record.map.coverage() - record.coverage) * kCells;
            qInfo("trial %d: %.0f cells covered, rebuilt %+.1f", record.trial, record.coverage * kCells,
                  difference);
            QVERIFY2(std::abs(difference) <= 4.0, qPrintable(QString::number(difference)));
            const auto played = session::mapAt(level, *track, record.trial, 1e9);
            QVERIFY(std::abs(played.coverage() - record.coverage) < 0.02); // one pose for four ticks
            QCOMPARE(session::mapAt(level, *track, record.trial, track->trial(record.trial)->start_s - 1.0)
                         .coverage(),
                     0.0);
        }
    }

    void judgementIsThatOfTheScores() {
        OpenStored stored(*m_site.database, m_session);
        const auto records = recordOf(*stored.session);
        int hits = 0;
        int alarms = 0;
        int lumps = 0;
        double coverage = 0.0;
        for (const session::PalpationTrialRecord& record : *records) {
            hits += record.answer.hits();
            alarms += record.answer.falseAlarms();
            lumps += static_cast<int>(record.answer.truth.lumps.size());
            coverage += 50.0 * record.coverage;
        }
        QCOMPARE(lumps, 1);
        QCOMPARE(sessionValue(m_scores, "palpation_hits"), double(hits));
        QCOMPARE(sessionValue(m_scores, "palpation_misses"), double(lumps - hits));
        QCOMPARE(sessionValue(m_scores, "palpation_false_alarms"), double(alarms));
        QVERIFY(std::abs(sessionValue(m_scores, "coverage") - coverage) < 1e-9);
        QVERIFY(sessionValue(m_scores, "searching_time") > 1.0);
        QVERIFY(sessionValue(m_scores, "pressing_time") > 0.5);
        QVERIFY(std::isnan(sessionValue(m_scores, "palpation_d_prime"))); // 1 and 17 regions are too few
    }

    /// Completed, not familiarisation, the same hand, device class and level: nothing else is pooled.
    void whichSessionsArePooled() {
        auto copy = tests::copyOf(*m_site.database, m_session);
        auto stopped = copy;
        tests::cutFrames(stopped.frames, 4000, core::CommandKind::end);
        auto practice = copy;
        practice.familiarisation = true;
        const auto actor = database::Actor::simulated();
        for (const tests::MadeSession* made : {&copy, &stopped, &practice})
            tests::store(*m_site.database, actor, *made);
        OpenStored stored(*m_site.database, m_session);
        const auto& summary = stored.session->record().summary;
        const auto pooled = [&](session::DetectionQuery query) {
            auto out = session::detectionOf(*stored.connection, actor, query);
            return out ? out->sessions : -1;
        };
        session::DetectionQuery query{summary.person, 2, summary.felt, "expert"};
        QCOMPARE(pooled(query), 2); // the run itself and its whole copy
        const auto both = session::detectionOf(*stored.connection, actor, query);
        QCOMPARE(both->trials, 2); // each begins with an introduction, which is left out
        QCOMPARE(both->counts().ofSignal, 0);
        QCOMPARE(both->counts().ofNoise, 18);
        query.level = 0;
        QCOMPARE(pooled(query), 2);
        query.level = 3;
        QCOMPARE(pooled(query), 0);
        QCOMPARE(pooled({summary.person, 2, !summary.felt, "expert"}), 0);
        QCOMPARE(pooled({summary.person, 2, summary.felt, ""}), 0);
        const auto cancelled =
            session::detectionOf(*stored.connection, actor, {summary.person, 2, summary.felt, "expert"},
                                 [](double) { return false; });
        QVERIFY(!cancelled && cancelled.error().code == core::ErrorCode::cancelled);
    }

private:
    SessionFixture m_site;
    database::SessionId m_session = 0;
    scoring::ScoreCard m_scores;
};

QTEST_GUILESS_MAIN(TestPalpationReview)
#include "test_palpation_looked_back.moc"
