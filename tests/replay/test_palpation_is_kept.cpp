// SPDX-License-Identifier: GPL-3.0-or-later
// Whole palpations: they replay to the same bits, and their scores are the same from the run, from the
// recording and from the exported file.
#include "scoring/score_calculator.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"
#include "session/replayer.h"
#include "session/session_export.h"
#include "support/session_fixture.h"

#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/cues/report_word.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using simulation::ReportField;
using tests::OpenStored;
using tests::SessionFixture;

namespace {

const catalogue::Catalogue& shipped() {
    static const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return *catalogue;
}

/// A shipped level with two trials of 12 s.
catalogue::ExerciseLevel twoTrials(int number, const QJsonObject& change = {}) {
    QJsonObject json =
        QJsonDocument::fromJson(QByteArray::fromStdString(shipped().find("palpation", number)->resolvedJson))
            .object();
    QJsonObject level = json["level"].toObject();
    QJsonObject parameters = level["parameters"].toObject();
    parameters["trials"] = 2;
    parameters["catch_trials"] = 1;
    parameters["trial_limit_s"] = 12;
    for (auto it = change.begin(); it != change.end(); ++it)
        parameters[it.key()] = it.value();
    level["parameters"] = parameters;
    json["level"] = level;
    auto changed =
        catalogue::fromResolvedJson(QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString());
    if (!changed)
        qFatal("%s", changed.error().message.c_str());
    return *changed;
}

double truthOf(const scoring::TrialTrace& trial, const std::string& id) {
    for (const scoring::NamedValue& value : trial.truth)
        if (value.id == id)
            return value.value;
    return std::nan("");
}

const std::vector<double>& quantityOf(const scoring::TrialTrace& trial, const std::string& id) {
    static const std::vector<double> kNone;
    for (const scoring::QuantityTrace& quantity : trial.quantities)
        if (quantity.id == id)
            return quantity.values;
    return kNone;
}

/// A hand-held trace: presses at one place after the other, marks the third, rates it, and says that it is
/// done.
scoring::TraceRows reportingTrace() {
    scoring::TraceRows rows;
    rows.source = "report.csv";
    const auto add = [&rows](double t_s, double x_m, double z_m, std::uint32_t buttons) {
        scoring::TraceRow row;
        row.t_s = t_s;
        row.p_WT_m = core::Vec3(x_m, 0.0, z_m);
        row.buttons = buttons;
        rows.rows.push_back(row);
    };
    for (int n = 0; n < 9000; ++n) {
        const double t_s = 0.001 * n;
        const double x_m = t_s < 5.0 ? -0.02 : t_s < 6.0 ? 0.0 : 0.02;
        const double z_m = t_s < 4.0 ? 0.02 : -0.002 + 0.005 * std::cos(2.0 * 3.14159265 * t_s);
        const auto word = [](ReportField field, unsigned value) {
            return core::reportButtons(simulation::reportWord(field, value));
        };
        const std::uint32_t buttons = n >= 6500 && n < 6600   ? core::kButtonMark
                                      : n >= 6700 && n < 6750 ? word(ReportField::size, 68)
                                      : n >= 6800 && n < 6850 ? word(ReportField::confidence, 4)
                                      : n >= 7000 && n < 7050 ? word(ReportField::done, 0)
                                                              : 0U;
        add(t_s, x_m, z_m, buttons);
    }
    return rows;
}

} // namespace

class TestPalpationIsKept : public QObject {
    Q_OBJECT
private slots:
    void scriptedHands_data() {
        QTest::addColumn<int>("number");
        QTest::addColumn<QString>("mechanism");
        for (const catalogue::ExerciseLevel& level : shipped().find("palpation")->levels)
            QTest::newRow(level.id.c_str()) << level.number << QString();
        QTest::newRow("two fingers on the gimbal") << 5 << QStringLiteral("gimbal_hprd");
    }
    void scriptedHands() {
        QFETCH(int, number);
        QFETCH(QString, mechanism);
        const catalogue::ExerciseLevel level = twoTrials(number);
        SessionFixture site;
        session::TrainingRequest request = site.request(level, "expert", 7);
        const std::string held = mechanism.toStdString();
        auto station = session::scriptedStation(**session::exerciseKind("palpation"), level, "expert", 7,
                                                {.mechanism = held});
        QVERIFY2(station, station ? "" : station.error().message.c_str());
        QCOMPARE(station->tools.size(), std::size_t(number >= 4 ? 2 : 1));
        QCOMPARE(QString::fromStdString(station->tools[0].device->descriptor().kinematics),
                 mechanism.isEmpty() ? "fingertip_arm" : mechanism);
        request.station = std::move(*station);
        const auto result = site.run(std::move(request));
        QVERIFY2(result, result ? "" : result.error().message.c_str());
        isKept(site, level, *result);
    }

    // Buttons of a trace say what was found, as a command does.
    void reportsOfATrace() {
        const catalogue::ExerciseLevel level = twoTrials(1);
        SessionFixture site;
        session::TrainingRequest request = site.request(level, "novice", 7);
        auto station = session::traceStation(reportingTrace());
        QVERIFY2(station, station ? "" : station.error().message.c_str());
        request.station = std::move(*station);
        const auto result = site.run(std::move(request));
        QVERIFY2(result, result ? "" : result.error().message.c_str());
        isKept(site, level, *result);
        const scoring::SessionTrace trace = exported(site, *result);
        const scoring::TrialTrace& first = trace.trials.at(0);
        QVERIFY(first.completed && !first.timedOut);
        QCOMPARE(quantityOf(first, "report_count").back(), 4.0);
        const auto& fields = quantityOf(first, "report_field");
        QCOMPARE(fields.back(), static_cast<double>(ReportField::done));
        const auto& values = quantityOf(first, "report_value");
        QVERIFY(std::find(values.begin(), values.end(), 68.0) != values.end());
        QVERIFY(trace.trials.size() < 2 || !trace.trials[1].completed); // its end reports nothing
        QVERIFY(trace.trials.size() < 2 || quantityOf(trace.trials[1], "report_count").back() == 0.0);
    }

    // What a control moved is true where it went.
    void movedLumpsAreTrueWhereTheyWent() {
        const QJsonObject still{{"catch_trials", 0}};
        QJsonObject moving = still;
        moving["control_move_after_s"] = 1.0;
        moving["control_move_x_mm"] = 80.0 / 3.0;
        const catalogue::ExerciseLevel level = twoTrials(2, moving);
        SessionFixture site;
        const auto result = site.run(site.request(level, "novice", 7));
        QVERIFY2(result, result ? "" : result.error().message.c_str());
        isKept(site, level, *result);
        const auto kind = *session::exerciseKind("palpation");
        for (const scoring::TrialTrace& trial : exported(site, *result).trials) {
            QCOMPARE(quantityOf(trial, "lumps_moved").back(), 1.0);
            scoring::TrialTrace planned;
            planned.trial = trial.trial;
            kind->addTruth(level, 7, planned);
            QVERIFY(std::abs(truthOf(trial, "lump_0_x_m") - truthOf(planned, "lump_0_x_m") - 0.08 / 3.0) <
                    1e-6);
            QVERIFY(std::abs(truthOf(trial, "lump_0_y_m") - truthOf(planned, "lump_0_y_m")) < 1e-6);
        }
    }

private:
    static scoring::SessionTrace exported(SessionFixture& site, const session::TrainingResult& result) {
        OpenStored stored(*site.database, result.session);
        const QString path = QString::fromStdString(site.folder() + "/palpation.csv");
        const auto done = session::exportCsv(*stored.session, path);
        const auto rows = scoring::readTraceCsvFile(path.toStdString());
        if (!done || !rows)
            qFatal("%s", (done ? rows.error() : done.error()).message.c_str());
        auto trace = scoring::buildSessionTrace(*rows, "palpation");
        if (!trace)
            qFatal("%s", trace.error().message.c_str());
        return std::move(*trace);
    }

    static void isKept(SessionFixture& site, const catalogue::ExerciseLevel& level,
                       const session::TrainingResult& result) {
        {
            OpenStored stored(*site.database, result.session);
            const auto replay = session::replaySession(*stored.session);
            QVERIFY2(replay, replay ? "" : replay.error().message.c_str());
            QVERIFY(replay->comparable && replay->identical);
            const auto again = stored.session->computeScores();
            QVERIFY(again && session::sameScores(*again, result.scores));
        }
        const scoring::SessionTrace trace = exported(site, result);
        std::vector<scoring::MetricRequest> wanted;
        for (const auto& metric : level.metrics)
            wanted.push_back({metric.id, metric.version});
        const auto card = scoring::calculateScore(trace, wanted, level.gates, true);
        QVERIFY2(card, card ? "" : card.error().message.c_str());
        for (std::size_t i = 0; i < card->metrics.size(); ++i) {
            if (qEnvironmentVariableIsSet("CHIRON_SHOW_SCORES"))
                qInfo("%s %g %s", card->metrics[i].id.c_str(), card->metrics[i].value.value_or(std::nan("")),
                      card->metrics[i].reason.c_str());
            QVERIFY2(card->metrics[i].value == result.scores.metrics[i].value, card->metrics[i].id.c_str());
        }
    }
};

QTEST_GUILESS_MAIN(TestPalpationIsKept)
#include "test_palpation_is_kept.moc"
