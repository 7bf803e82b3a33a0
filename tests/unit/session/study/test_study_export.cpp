// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves a study: nobody's data over another's, and no number where nothing was measured.
#include "catalogue/study_json.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "session/bids_motion.h"
#include "session/study/fidelity_meter.h"
#include "session/study/study_runner.h"
#include "session/study_export.h"
#include "session/study_export_data.h"
#include "session/study_export_tables.h"
#include "simulation/attributes/bristle_friction.h"
#include "support/session_fixture.h"
#include "support/study_designs.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include <cmath>
#include <map>
#include <set>

using namespace chiron;

namespace {

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The cells of a column.
QList<QByteArray> column(const QByteArray& table, char separator, const char* name) {
    QList<QByteArray> lines = table.trimmed().split('\n');
    const qsizetype at = lines.takeFirst().split(separator).indexOf(name);
    QList<QByteArray> cells;
    for (const QByteArray& line : lines)
        cells << (at < 0 ? QByteArray("no such column") : line.split(separator).value(at));
    return cells;
}

/// A study whose conditions and participants differ in signs that names of BIDS' files cannot have, done
/// without a rendering.
struct Site {
    Site() {
        design = testing::rank3Study(psychophysics::Attribute::stiffness, 4, 4);
        design.conditions.front().id = "a_b";
        design.conditions.push_back(design.conditions.front());
        design.conditions.back().id = "a__b";
        const auto made = fixture.database->write(
            [&](database::WriteContext& context) -> core::Result<database::StudyNumber> {
                database::StudyRepository studies(context.connection(), actor);
                auto number =
                    studies.createStudy(design.id, "Two", catalogue::studyJson(design).toStdString());
                if (number)
                    CHIRON_TRY(studies.freezeStudy(*number));
                for (const char* code : {"S_01", "S01"})
                    if (number)
                        CHIRON_TRY(studies.enrolParticipant(*number, "", 0, "weber:0.12", code));
                return number;
            });
        if (!made)
            qFatal("%s", made.error().message.c_str());
        study = *made;
        for (const char* code : {"S_01", "S01"}) {
            session::StudyRunRequest request;
            request.study = study;
            request.participantCode = code;
            request.observer = {.weber = 0.12};
            request.quick = true;
            if (const auto report = session::runStudyHeadless(*fixture.database, actor, request); !report)
                qFatal("%s", report.error().message.c_str());
        }
    }
    core::Result<void> writeTo(const QString& folder, bool bids) {
        auto connection = fixture.database->openReader();
        database::StudyReader reader(**connection, actor);
        const std::filesystem::path path(folder.toStdString());
        return bids ? session::exportStudyBids(reader, **connection, actor, study, path)
                    : session::exportStudyCsv(reader, study, path);
    }

    tests::SessionFixture fixture;
    database::Actor actor = database::Actor::simulated();
    psychophysics::StudyDesign design;
    database::StudyNumber study = 0;
};

/// Half a second on one place: pressed with 1 N, slid with friction.
session::TrialFidelity stroked(simulation::ComparedAttribute attribute, double asked, bool measures,
                               bool touches = true) {
    simulation::ComparisonParameters parameters;
    parameters.attribute = attribute;
    parameters.places = 1;
    session::FidelityMeter meter(parameters, {}, false);
    meter.begin({asked});
    session::FidelitySample sample;
    sample.phase = core::TrialPhase::running;
    sample.full = true;
    sample.measures = measures;
    for (int i = 0; i < 1000; ++i) {
        sample.now_ns = (i + 1) * 1'000'000;
        sample.place = touches && i < 500 ? 1 : 0;
        const double push_N = 1.0 + 0.2 * std::sin(0.05 * i);
        sample.depth_m = push_N / 400.0;
        sample.velocity_m_per_s = {i < 500 ? 0.05 : 0.0, 0.0, 0.0};
        sample.commanded_N = {-0.1 * push_N, 0.0, push_N}; // μ of 0.1
        sample.measured_N = {-0.1 * push_N, 0.0, push_N + 0.05};
        meter.add(sample);
    }
    return meter.finish();
}

/// Three seconds of strokes, 2.4 a second, pressed with 1.75 N, on a surface of friction μ.
session::PlaceFidelity strokedThere(double mu, double swing_m) {
    simulation::ComparisonParameters parameters;
    parameters.attribute = simulation::ComparedAttribute::friction;
    parameters.places = 1;
    session::FidelityMeter meter(parameters, {}, false);
    meter.begin({mu});
    simulation::BristleFriction bristle;
    session::FidelitySample sample;
    sample.phase = core::TrialPhase::running;
    sample.full = true;
    sample.place = 1;
    core::Vec3 at = core::Vec3::Zero();
    for (int i = 0; i < 3000; ++i) {
        const double t_s = i * 1e-3;
        sample.now_ns = (i + 1) * std::int64_t{1'000'000};
        sample.velocity_m_per_s = {0.004 * std::cos(62.0 * t_s), swing_m * 15.0 * std::sin(15.0 * t_s), 0.0};
        at += 1e-3 * core::Vec3(sample.velocity_m_per_s[0], sample.velocity_m_per_s[1], 0.0);
        const core::Vec3 held =
            bristle.update(at, core::Vec3::UnitZ(), 1.75, mu, parameters.object.bristleStiffness_N_per_m);
        sample.commanded_N = {held.x(), held.y(), 1.75};
        meter.add(sample);
    }
    return meter.finish().places.front();
}

} // namespace

class TestStudyExport : public QObject {
    Q_OBJECT
private slots:
    /// A trial is scored if it has an answer, or for an adjustment a value, and is neither practice, undone
    /// nor spoiled.
    void whichTrialsAreScored() {
        database::StudyTrial answered;
        answered.procedure = 1;
        answered.arrangement = 3;
        answered.answer = 0;
        answered.outcome = 1;
        answered.difference = 0.25;
        database::StudyTrial practice = answered, undone = answered, spoiled = answered,
                             unanswered = answered, set = answered;
        practice.practice = true;
        undone.undone = true;
        spoiled.spoiled = "time";
        unanswered.answer = -1;
        set.answer = -1;
        set.value = 0.02;
        const auto scored = session::scoredTrialsOf({practice, answered, undone, spoiled, unanswered, set});
        QCOMPARE(scored.size(), std::size_t{2});
        QVERIFY(scored[0].procedure == 1 && scored[0].arrangement == 3 && scored[0].answer == 0 &&
                scored[0].outcome == 1);
        QVERIFY(scored[0].difference == 0.25 && !scored[0].value);
        QVERIFY(scored[1].answer == -1 && scored[1].value == 0.02);
        QVERIFY(session::scoredTrialsOf({practice, undone, spoiled, unanswered}).empty());
    }
    /// What a stop interrupted is counted apart from what was presented again, as everywhere else.
    void interruptionsAreNotRepetitions() {
        Site site;
        const auto connection = site.fixture.database->openReader();
        database::StudyReader reader(**connection, site.actor);
        auto data = session::gatherStudy(reader, site.study);
        QVERIFY(data);
        std::vector<database::StudyTrial>& trials = data->participants.front().runs.front().trials;
        QVERIFY(!trials.empty());
        trials.resize(8, trials.front());
        for (database::StudyTrial& trial : trials) {
            trial.practice = false;
            trial.spoiled.clear();
        }
        trials[0].practice = true;
        trials[0].spoiled = "taken_back";
        trials[1].spoiled = trials[2].spoiled = "speed";
        trials[3].spoiled = database::kInterrupted;
        const session::ExportTable table = session::runsTable(*data);
        const auto count = [&](const char* name) {
            for (std::size_t i = 0; i < table.columns.size(); ++i)
                if (QString(table.columns[i].name) == QLatin1String(name))
                    return table.rows.front()[static_cast<qsizetype>(i)].toInt();
            return -1;
        };
        const int all = static_cast<int>(trials.size());
        QCOMPARE(count("presentations"), all);
        QCOMPARE(count("practice"), 1);
        QCOMPARE(count("spoiled"), 2);
        QCOMPARE(count("interrupted"), 1);
        QCOMPARE(count("scored"), all - 4);
    }
    /// The order that was said is right where it is the one that lay there, the first of all orders like any
    /// other.
    void whatWasSaidIsJudgedByWhatLayThere() {
        Site site;
        QTemporaryDir folder;
        QVERIFY(site.writeTo(folder.filePath("out"), false));
        const QByteArray table = bytesOf(folder.filePath("out/trials.csv"));
        const QList<QByteArray> lay = column(table, ',', "arrangement"),
                                said = column(table, ',', "response"), right = column(table, ',', "correct");
        QVERIFY(lay.size() > 8);
        std::set<QByteArray> judgedRight;
        for (qsizetype i = 0; i < lay.size(); ++i) {
            QCOMPARE(right[i], QByteArray(said[i] == lay[i] ? "1" : "0"));
            if (said[i] == lay[i])
                judgedRight.insert(lay[i]);
        }
        QVERIFY(judgedRight.count("0") == 1 && judgedRight.size() > 2);
    }
    void labelsAreNeverTheSame() {
        using Labels = std::map<QString, QString>;
        auto made = session::bidsLabels({"S_01", "S01", "K7M", "S-01", "S01"});
        QCOMPARE(made, (Labels{{"S01", "S01"}, {"S-01", "S01x2"}, {"S_01", "S01x3"}, {"K7M", "K7M"}}));
        QCOMPARE(session::bidsLabels({"S-01", "K7M", "S01", "S_01"}), made); // in any order
        made = session::bidsLabels({"S01", "s01", "S01x2"});                 // file systems may not tell case
        QCOMPARE(made, (Labels{{"S01", "S01"}, {"S01x2", "S01x2"}, {"s01", "s01x3"}}));
    }
    /// Letters and digits alone; what follows something else begins with a capital.
    void labelsAreLettersAndDigits() {
        for (const auto& [words, label] :
             std::initializer_list<std::pair<const char*, const char*>>{{"a z A Z 0 9", "aZAZ09"},
                                                                        {"two-handed tube", "twoHandedTube"},
                                                                        {"_left", "left"},
                                                                        {"@[`{/:", "x"},
                                                                        {"", "x"}})
            QCOMPARE(session::bidsLabel(QString::fromLatin1(words)), QString::fromLatin1(label));
    }
    void bidsKeepsEverybodyApart() {
        Site site;
        const QString folder = QString::fromStdString(site.fixture.folder()) + "/bids";
        const auto written = site.writeTo(folder, true);
        QVERIFY2(written, written ? "" : written.error().message.c_str());
        const QByteArray participants = bytesOf(folder + "/participants.tsv");
        QCOMPARE(column(participants, '\t', "participant_id"), (QList<QByteArray>{"sub-S01x2", "sub-S01"}));
        QCOMPARE(column(participants, '\t', "code"), (QList<QByteArray>{"S_01", "S01"}));
        std::set<QString> conditions;
        for (const char* subject : {"S01", "S01x2"}) {
            const QDir beh(folder + "/sub-" + subject + "/beh");
            QCOMPARE(beh.entryList({"*_beh.tsv"}, QDir::Files).size(), 2);
            for (const QString& name : beh.entryList({"*_beh.json"}, QDir::Files)) {
                const QJsonObject sidecar = QJsonDocument::fromJson(bytesOf(beh.filePath(name))).object();
                QCOMPARE(sidecar["Participant"].toString(), QLatin1String(subject) == QLatin1String("S01")
                                                                ? QStringLiteral("S01")
                                                                : QStringLiteral("S_01"));
                conditions.insert(sidecar["Condition"].toString());
                QVERIFY(name.contains("_task-" + sidecar["TaskName"].toString() + "_"));
            }
        }
        QCOMPARE(conditions, (std::set<QString>{"a_b", "a__b"}));
    }
    /// By how much the second best stimulus was worse, to the last digit, and nothing where nothing is
    /// weighed.
    void marginsAreExportedAsTheyAre() {
        Site site;
        const QString folder = QString::fromStdString(site.fixture.folder()) + "/margins";
        QVERIFY(site.writeTo(folder, false));
        const QList<QByteArray> cells = column(bytesOf(folder + "/trials.csv"), ',', "entropy_margin");
        auto connection = site.fixture.database->openReader();
        database::StudyReader reader(**connection, site.actor);
        qsizetype row = 0;
        int finite = 0;
        const auto people = reader.participants(site.study).value();
        for (const database::Participant& who : people) {
            const auto runs = reader.runs(who.id).value();
            for (const database::StudyRun& run : runs) {
                const auto trials = reader.studyTrials(run.id).value();
                for (const database::StudyTrial& trial : trials) {
                    QVERIFY(row < cells.size());
                    const QByteArray& cell = cells[row++];
                    finite += std::isfinite(trial.entropyMargin) ? 1 : 0;
                    QVERIFY2(std::isfinite(trial.entropyMargin) ? cell.toDouble() == trial.entropyMargin
                                                                : cell == "n/a",
                             cell.constData());
                }
            }
        }
        QCOMPARE(row, cells.size());
        QVERIFY(finite > 8);
    }
    /// Every dictionary says how "n/a" is read, and each row has a cell of each column.
    void dictionariesSayHowToRead() {
        Site site;
        const QString csv = QString::fromStdString(site.fixture.folder()) + "/read_csv",
                      bids = QString::fromStdString(site.fixture.folder()) + "/read_bids";
        QVERIFY(site.writeTo(csv, false) && site.writeTo(bids, true));
        for (const QString& file : {csv + "/data_dictionary.csv", csv + "/data_dictionary.json",
                                    csv + "/README.txt", bids + "/README"}) {
            const QByteArray words = bytesOf(file);
            QVERIFY2(words.contains("na.strings = ") && words.contains("na_values=["), qPrintable(file));
        }
        for (const char* table :
             {"trials", "runs", "participants", "questionnaires", "estimates", "quality"}) {
            const QList<QByteArray> lines = bytesOf(csv + '/' + table + ".csv").trimmed().split('\n');
            for (const QByteArray& name : lines.front().split(','))
                QVERIFY2(bytesOf(csv + "/data_dictionary.csv").contains(QByteArray(table) + ',' + name + ','),
                         (QByteArray(table) + ' ' + name).constData());
        }
        for (const char* name : {"device", "force_class", "paused_s"}) {
            QCOMPARE(column(bytesOf(csv + "/trials.csv"), ',', name).front(), QByteArray("n/a"));
            QVERIFY(column(bytesOf(csv + "/runs.csv"), ',', name).front() != "no such column");
        }
    }
    void quickRunsMeasureNothing() {
        Site site;
        const QString folder = QString::fromStdString(site.fixture.folder()) + "/csv";
        const auto written = site.writeTo(folder, false);
        QVERIFY2(written, written ? "" : written.error().message.c_str());
        const QByteArray trials = bytesOf(folder + "/trials.csv");
        for (const char* name : {"force_measured", "force_error_rms", "late_ticks", "worst_lateness",
                                 "saturated", "duration", "peak_force", "mean_speed", "contacts",
                                 "rendering_error", "exploration_time", "response_time"}) {
            const QList<QByteArray> cells = column(trials, ',', name);
            QVERIFY(!cells.isEmpty());
            for (const QByteArray& cell : cells)
                QVERIFY2(cell == "n/a", (QByteArray(name) + ": " + cell).constData());
        }
        QCOMPARE(column(bytesOf(folder + "/quality.csv"), ',', "exploration_time").front(),
                 QByteArray("n/a"));
    }
    void fidelityHasNoNumberOfWhatWasNotMeasured() {
        using simulation::ComparedAttribute;
        QVERIFY(std::isnan(stroked(ComparedAttribute::friction, 0.1, false).forceErrorRms_N));
        QVERIFY(std::abs(stroked(ComparedAttribute::friction, 0.1, true).forceErrorRms_N - 0.05) < 1e-9);
        const session::TrialFidelity untouched = stroked(ComparedAttribute::stiffness, 150.0, true, false);
        QVERIFY(std::isnan(untouched.forceErrorRms_N) && std::isnan(untouched.saturated) &&
                std::isnan(untouched.stiffnessError));
        QCOMPARE(untouched.contacts, 0);
        for (const auto attribute : {ComparedAttribute::roughness, ComparedAttribute::deformation})
            QVERIFY(std::isnan(stroked(attribute, 0.1, true).stiffnessError));
    }
    /// Friction that is rendered at half of what was asked for is told, and is a limit.
    void frictionIsALimit() {
        const session::TrialFidelity half = stroked(simulation::ComparedAttribute::friction, 0.2, false);
        QVERIFY2(std::abs(half.stiffnessError - 0.5) < 1e-6,
                 qPrintable(QString::number(half.stiffnessError)));
        QCOMPARE(half.outside, std::string("stiffness_error"));
    }
    /// A hand that trembles across its strokes never quite stands where it turns; what it drags along takes 2
    /// μ f_n/σ₀ to come after.
    void frictionIsThatOfFullSliding() {
        for (const double mu : {0.05, 0.25, 0.61, 1.0})
            for (const double swing_m : {0.004, 0.007}) {
                const session::PlaceFidelity place = strokedThere(mu, swing_m);
                const QByteArray what = QByteArray::number(mu) + " over " + QByteArray::number(swing_m) +
                                        ": " + QByteArray::number(place.rendered);
                QVERIFY2(std::abs(place.rendered / mu - 1.0) < 0.02 && place.standardError < 0.01 * mu,
                         what.constData());
            }
        QVERIFY(std::isnan(
            strokedThere(1.0, 0.001).rendered)); // never slides in full: no number instead of a wrong one
    }
    /// Of the whole trial, as the limit is: half of it slid at 50 mm/s, half at rest.
    void meanSpeedIsOfTheWholeTrial() {
        const session::TrialFidelity fidelity = stroked(simulation::ComparedAttribute::friction, 0.1, false);
        QVERIFY(std::abs(fidelity.meanSpeed_m_per_s - 0.025) < 1e-9);
        QVERIFY(std::abs(fidelity.places.front().meanSpeed_m_per_s - 0.05) < 1e-9);
        Site site;
        const QString folder = QString::fromStdString(site.fixture.folder()) + "/csv";
        QVERIFY(site.writeTo(folder, false));
        const QJsonObject files =
            QJsonDocument::fromJson(bytesOf(folder + "/data_dictionary.json")).object()["files"].toObject();
        QVERIFY(files["trials.csv"]["columns"]["mean_speed"]["Description"].toString().contains(
            "whole presentation"));
        QVERIFY(files["estimates.csv"]["columns"]["criterion"]["Description"].toString().contains(
            "75 % correct in 2AFC whatever it is"));
    }
};

QTEST_GUILESS_MAIN(TestStudyExport)
#include "test_study_export.moc"
