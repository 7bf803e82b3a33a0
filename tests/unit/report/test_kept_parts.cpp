// SPDX-License-Identifier: GPL-3.0-or-later
// What a report tells of each exercise beside its metrics, of trials in which much happens and of the same
// with something lacking, against what was kept. A change that is meant is kept anew: CHIRON_STORE_OUTLINES=1
// build/release/tests/unit/report/test_kept_parts
#include "app/exercises/elastic_tube/report/tube_report.h"
#include "app/exercises/object_handling/report/handling_report.h"
#include "app/exercises/palpation/report/palpation_section.h"
#include "app/exercises/sphere_apex/report/apex_report.h"
#include "app/exercises/urethra_insertion/report/insertion_report.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "session_report/exercise_reporter.h"
#include "simulation/comparison/comparison_parameters.h"
#include "support/kept_figures.h"
#include "unit/scoring/drawn_traces.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::tests;

namespace {

constexpr double kNone = -99.0; ///< what is not there

double sumOf(const std::vector<double>& values) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::isfinite(values[i]))
            sum += values[i] * (1.0 + 1e-3 * static_cast<double>(i));
    return sum;
}

long gapsIn(const std::vector<double>& values) {
    return std::count_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
}

void tell(Figures& out, const char* name, const std::vector<double>& values) {
    out.add(QLatin1String(name), values.size(), gapsIn(values), sumOf(values));
}

void tell(Figures& out, const report::ApexError& error) {
    out.add(QStringLiteral("apex"), error.trial, error.x_percent, error.y_percent, error.miss,
            error.timedOut);
}

void tell(Figures& out, const report::InsertionProfile& profile) {
    tell(out, "depth", profile.depth_mm);
    tell(out, "offset in", profile.offsetIn_mm);
    tell(out, "offset out", profile.offsetOut_mm);
    tell(out, "alignment in", profile.alignmentIn_deg);
    tell(out, "alignment out", profile.alignmentOut_deg);
    out.add(QStringLiteral("canal"), profile.bend_mm, profile.neck_mm, profile.goal_mm, profile.landmarks,
            profile.landmarksSeen);
}

void tell(Figures& out, const report::TubeReport& tube) {
    tell(out, "time", tube.t_s);
    tell(out, "tension", tube.tension_N);
    tell(out, "band low", tube.bandLow_N);
    tell(out, "band high", tube.bandHigh_N);
    tell(out, "stretch", tube.stretch_mm);
    tell(out, "mark low", tube.markLow_mm);
    tell(out, "mark high", tube.markHigh_mm);
    tell(out, "retraction", tube.retraction_N);
    tell(out, "trial starts", tube.trialStart_s);
    out.add(QStringLiteral("limits"), tube.retractionLow_N, tube.retractionHigh_N, tube.overStretch_mm);
    for (const auto& span : tube.paused)
        out.add(QStringLiteral("paused"), span.begin_s, span.end_s);
    for (const report::TubeTrialRow& row : tube.rows)
        out.add(QStringLiteral("tube"), row.trial, static_cast<int>(row.outcome),
                row.target_N.value_or(kNone), row.error_N.value_or(kNone), row.inBand_s.value_or(kNone),
                row.stretchMax_mm, row.overStretches.value_or(kNone), row.drops.value_or(kNone),
                row.retractionInBand_percent.value_or(kNone));
}

void tell(Figures& out, const report::HandlingReport& handling) {
    out.add(QStringLiteral("limits"), handling.squeezeLimit_N, handling.targetRadius_mm);
    for (const report::HandlingTrialRow& row : handling.rows)
        out.add(QStringLiteral("handling"), row.trial, static_cast<int>(row.outcome),
                row.squeezeMax_N.value_or(kNone), row.overLimit_s.value_or(kNone), row.x_mm.value_or(kNone),
                row.y_mm.value_or(kNone), row.fromTarget_mm.value_or(kNone), row.taken,
                row.heaviest ? static_cast<double>(*row.heaviest) : kNone);
}

void tell(Figures& out, const report::PalpationReport& palpation) {
    const core::DetectionCounts& counts = palpation.regions;
    out.add(QStringLiteral("regions"), counts.hits, counts.ofSignal, counts.falseAlarms, counts.ofNoise);
    for (const report::PalpationTrialReport& trial : palpation.trials) {
        out.add(QStringLiteral("palpation"), trial.trial, trial.timedOut, trial.map.coverage(),
                trial.map.half_m().x(), trial.map.half_m().y(), trial.map.coverForce_N(),
                trial.view.regionColumns, trial.view.regionRows, trial.view.bands.cover_N,
                trial.view.bands.low_N, trial.view.bands.high_N, trial.view.bands.limit_N,
                trial.view.lumps.size(), trial.view.findings.size());
        for (const report::PalpationFindingRow& row : trial.rows)
            out.add(QStringLiteral("finding"), static_cast<int>(row.kind), row.number, row.x_mm, row.y_mm,
                    row.radius_mm, row.hardness, row.confidence, row.error_mm.value_or(kNone),
                    row.sizeError_mm.value_or(kNone));
    }
}

QStringList partsOf(const SessionTrace& trace, const catalogue::ExerciseLevel& level) {
    Figures out;
    const auto section = session_report::exerciseSectionOf(trace, level);
    if (const auto* apex = dynamic_cast<const report::ApexSection*>(section.get()))
        for (const report::ApexError& error : apex->errors())
            tell(out, error);
    if (const auto* insertion = dynamic_cast<const report::InsertionSection*>(section.get()))
        tell(out, insertion->profile());
    if (const auto* palpation = dynamic_cast<const report::PalpationSection*>(section.get()))
        tell(out, palpation->report());
    if (const auto* tube = dynamic_cast<const report::TubeSection*>(section.get()))
        tell(out, tube->tube());
    if (const auto* handling = dynamic_cast<const report::HandlingSection*>(section.get()))
        tell(out, handling->handling());
    if (out.lines.isEmpty())
        out.say(QStringLiteral("parts"), "none");
    return out.lines;
}

template <class Parameters> catalogue::ExerciseLevel levelOf(const char* exercise, Parameters parameters) {
    catalogue::ExerciseLevel level;
    level.exercise = exercise;
    level.parameters = std::move(parameters);
    return level;
}

} // namespace

class TestKeptParts : public QObject {
    Q_OBJECT
private slots:
    void partsOfDrawnTrials();
    void partsOfPalpations();
    void nothingElseIsKept() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/report/kept_parts.txt"), sameFigures};
};

void TestKeptParts::partsOfDrawnTrials() {
    const catalogue::ExerciseLevel levels[]{
        levelOf("sphere_apex", simulation::SphereApexParameters{}),
        levelOf("urethra_insertion", simulation::UrethraInsertionParameters{}),
        levelOf("elastic_tube", simulation::ElasticTubeParameters{}),
        levelOf("object_handling", simulation::ObjectHandlingParameters{}),
        levelOf("comparison", simulation::ComparisonParameters{}),
        levelOf("palpation", simulation::PalpationParameters{})};
    for (const catalogue::ExerciseLevel& level : levels) {
        QSet<QString> before;
        for (const auto& [name, change] : changes()) {
            SessionTrace changed = drawn();
            changed.exercise = level.exercise;
            for (std::size_t i = 0; i < changed.trials.size(); ++i)
                changed.trials[i].truth.push_back(
                    {"target_radius_m", 0.012 + 0.001 * static_cast<double>(i)});
            change(changed);
            const QStringList lines = partsOf(changed, level);
            QStringList only; // of a change what it changes
            for (const QString& line : lines)
                if (!before.contains(line))
                    only << line;
            if (before.isEmpty())
                before = QSet<QString>(lines.begin(), lines.end());
            const QString differs = m_kept.differs(
                QStringLiteral("%1, %2").arg(QString::fromStdString(level.exercise), QLatin1String(name)),
                only.isEmpty() ? QStringList{QStringLiteral("changes nothing")} : only);
            QVERIFY2(differs.isEmpty(), qPrintable(differs));
        }
    }
}

void TestKeptParts::partsOfPalpations() {
    const std::vector<TrialTrace> trials = palpated();
    simulation::PalpationParameters parameters;
    parameters.trials = static_cast<int>(trials.size());
    const catalogue::ExerciseLevel level = levelOf("palpation", parameters);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        SessionTrace trace = palpationSession({trials[i]});
        trace.trials[0].trial = static_cast<int>(i);
        const QString differs = m_kept.differs(QStringLiteral("palpation %1").arg(i), partsOf(trace, level));
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        for (std::size_t q = 0; q < trace.trials[0].quantities.size(); ++q) {
            SessionTrace lacks = trace;
            const QString id = QString::fromStdString(trace.trials[0].quantities[q].id);
            lacks.trials[0].quantities.erase(lacks.trials[0].quantities.begin() +
                                             static_cast<std::ptrdiff_t>(q));
            const QString lacking = m_kept.differs(QStringLiteral("palpation %1 without %2").arg(i).arg(id),
                                                   partsOf(lacks, level));
            QVERIFY2(lacking.isEmpty(), qPrintable(lacking));
        }
        for (std::size_t t = 0; t < trace.trials[0].truth.size(); ++t) {
            SessionTrace lacks = trace;
            const QString id = QString::fromStdString(trace.trials[0].truth[t].id);
            lacks.trials[0].truth.erase(lacks.trials[0].truth.begin() + static_cast<std::ptrdiff_t>(t));
            const QString lacking = m_kept.differs(
                QStringLiteral("palpation %1 with %2 not known").arg(i).arg(id), partsOf(lacks, level));
            QVERIFY2(lacking.isEmpty(), qPrintable(lacking));
        }
    }
}

QTEST_MAIN(TestKeptParts)
#include "test_kept_parts.moc"
