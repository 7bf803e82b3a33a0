// SPDX-License-Identifier: GPL-3.0-or-later
// Whole sessions of object handling: they replay to the same bits, and their scores are the same from the
// run, from the recording and from the exported file.
#include "app/exercises/object_handling/session/planned_handling.h"
#include "curriculum/exercises/object_handling/scoring/handling_truth.h"
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

const catalogue::Catalogue& shipped() {
    static const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return *catalogue;
}

/// A shipped level with two trials.
catalogue::ExerciseLevel twoTrials(int number) {
    QJsonObject json = QJsonDocument::fromJson(
                           QByteArray::fromStdString(shipped().find("object_handling", number)->resolvedJson))
                           .object();
    QJsonObject level = json["level"].toObject();
    QJsonObject parameters = level["parameters"].toObject();
    parameters["trials"] = 2;
    level["parameters"] = parameters;
    json["level"] = level;
    auto changed =
        catalogue::fromResolvedJson(QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString());
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

class TestObjectHandlingIsKept : public QObject {
    Q_OBJECT
private slots:
    void scriptedHands_data() {
        QTest::addColumn<int>("number");
        for (const catalogue::ExerciseLevel& level : shipped().find("object_handling")->levels)
            QTest::newRow(level.id.c_str()) << level.number;
    }
    void scriptedHands() {
        QFETCH(int, number);
        const catalogue::ExerciseLevel level = twoTrials(number);
        SessionFixture site;
        const auto result = site.run(site.request(level, "expert", 7));
        QVERIFY2(result, result ? "" : result.error().message.c_str());
        QCOMPARE(valueOf(result->scores, "procedure_completed"), 100.0);
        QVERIFY(valueOf(result->scores, "placement_error") < 14.0);
        QVERIFY(valueOf(result->scores, "squeeze_max") > 0.1);
        isKept(site, level, *result);
    }

private:
    void isKept(SessionFixture& site, const catalogue::ExerciseLevel& level,
                const session::TrainingResult& result) {
        OpenStored stored(*site.database, result.session);
        const auto replay = session::replaySession(*stored.session);
        QVERIFY2(replay, replay ? "" : replay.error().message.c_str());
        QVERIFY(replay->comparable && replay->identical);
        const auto again = stored.session->computeScores();
        QVERIFY(again && session::sameScores(*again, result.scores));

        const QString path = QString::fromStdString(site.folder() + "/handling.csv");
        const auto done = session::exportCsv(*stored.session, path);
        QVERIFY2(done, done ? "" : done.error().message.c_str());
        const auto rows = scoring::readTraceCsvFile(path.toStdString());
        QVERIFY2(rows, rows ? "" : rows.error().message.c_str());
        const auto trace = scoring::buildSessionTrace(*rows, "object_handling");
        QVERIFY2(trace, trace ? "" : trace.error().message.c_str());
        const session::SessionSetup& setup = stored.session->setup();
        const auto planned = session::plannedHandling(
            setup.level.parameters.as<simulation::ObjectHandlingParameters>(), setup.seed);
        const auto truths = stored.session->truths(scoring::handlingTruthOf);
        QVERIFY2(truths, truths ? "" : truths.error().message.c_str());
        QVERIFY(!truths->empty() && truths->size() == trace->trials.size() &&
                truths->size() <= planned.size());
        for (std::size_t i = 0; i < truths->size(); ++i)
            QVERIFY((*truths)[i] == planned[i] && planned[i].objects &&
                    scoring::handlingTruthIn(trace->trials[i]) == planned[i]);
        std::vector<scoring::MetricRequest> wanted;
        for (const auto& metric : level.metrics)
            wanted.push_back({metric.id, metric.version});
        const auto card = scoring::calculateScore(*trace, wanted, level.gates, true);
        QVERIFY2(card, card ? "" : card.error().message.c_str());
        for (std::size_t i = 0; i < card->metrics.size(); ++i) {
            if (qEnvironmentVariableIsSet("CHIRON_SHOW_SCORES"))
                qInfo("%s %g", card->metrics[i].id.c_str(), card->metrics[i].value.value_or(std::nan("")));
            QVERIFY2(card->metrics[i].value == result.scores.metrics[i].value, card->metrics[i].id.c_str());
        }
        QVERIFY(session::sameScores(*card, result.scores));
    }
};

QTEST_GUILESS_MAIN(TestObjectHandlingIsKept)
#include "test_object_handling_is_kept.moc"
