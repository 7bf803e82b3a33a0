// SPDX-License-Identifier: GPL-3.0-or-later
// Whole sessions of the elastic tube, one hand and two: they replay to the same bits, and their scores are the same from the
// run, from the recording and from the exported file.
#include "scoring/score_calculator.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"
#include "session/replayer.h"
#include "session/session_export.h"
#include "support/session_fixture.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using tests::OpenStored;
using tests::SessionFixture;

namespace {

/// A shipped level with two tubes of 30 s at most.
catalogue::ExerciseLevel shortTube(int number) {
    static const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(catalogue->find("elastic_tube", number)->resolvedJson)).object();
    QJsonObject level = json["level"].toObject();
    QJsonObject parameters = level["parameters"].toObject();
    parameters["trials"] = 2;
    parameters["trial_limit_s"] = 30;
    level["parameters"] = parameters;
    json["level"] = level;
    auto changed = catalogue::fromResolvedJson(QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString());
    if (!changed)
        qFatal("%s", changed.error().message.c_str());
    return *changed;
}

double valueOf(const scoring::ScoreCard& card, const std::string& id) {
    for (const scoring::MetricValue& metric : card.metrics)
        if (metric.id == id)
            return metric.value.value_or(std::nan(""));
    return std::nan("");
}

} // namespace

class TestElasticTubeIsKept : public QObject {
    Q_OBJECT
private slots:
    void everyLevel_data();
    void everyLevel();
};

void TestElasticTubeIsKept::everyLevel_data() {
    QTest::addColumn<int>("number");
    for (int number = 1; number <= 5; ++number)
        QTest::newRow(shortTube(number).id.c_str()) << number;
}

void TestElasticTubeIsKept::everyLevel() {
    QFETCH(int, number);
    const catalogue::ExerciseLevel level = shortTube(number);
    SessionFixture site;
    auto result = site.run(site.request(level, "expert", 7));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    QCOMPARE(valueOf(result->scores, "procedure_completed"), 100.0);
    QCOMPARE(valueOf(result->scores, "over_stretches"), 0.0);
    if (number == 1 || number == 3 || number == 4) {
        QVERIFY(valueOf(result->scores, "tension_error_rms") > 0.0);
        QVERIFY(valueOf(result->scores, "tension_error_sd") <= valueOf(result->scores, "tension_error_rms") + 1e-12);
        QVERIFY(valueOf(result->scores, "time_in_band") > 0.5 && valueOf(result->scores, "time_in_band") <= 3.1);
    }
    OpenStored stored(*site.database, result->session);
    const auto replay = session::replaySession(*stored.session);
    QVERIFY2(replay, replay ? "" : replay.error().message.c_str());
    QVERIFY(replay->comparable && replay->identical);
    const auto again = stored.session->computeScores();
    QVERIFY(again && session::sameScores(*again, result->scores));

    const QString path = QString::fromStdString(site.folder() + "/tube.csv");
    const auto done = session::exportCsv(*stored.session, path);
    QVERIFY2(done, done ? "" : done.error().message.c_str());
    const auto rows = scoring::readTraceCsvFile(path.toStdString());
    QVERIFY2(rows, rows ? "" : rows.error().message.c_str());
    const auto trace = scoring::buildSessionTrace(*rows, "elastic_tube");
    QVERIFY2(trace, trace ? "" : trace.error().message.c_str());
    std::vector<scoring::MetricRequest> wanted;
    for (const auto& metric : level.metrics)
        wanted.push_back({metric.id, metric.version});
    const auto card = scoring::calculateScore(*trace, wanted, level.gates, true);
    QVERIFY2(card, card ? "" : card.error().message.c_str());
    for (std::size_t i = 0; i < card->metrics.size(); ++i)
        QVERIFY2(card->metrics[i].value == result->scores.metrics[i].value, card->metrics[i].id.c_str());
    QVERIFY(session::sameScores(*card, result->scores));
}

QTEST_GUILESS_MAIN(TestElasticTubeIsKept)
#include "test_elastic_tube_is_kept.moc"
