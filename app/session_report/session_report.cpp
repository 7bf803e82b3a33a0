// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/session_report.h"

#include "database/repositories/score_repository.h"
#include "recording/digest.h"
#include "session_report/insertion_profile.h"
#include "session_report/palpation_report.h"
#include "session_report/series_maker.h"
#include "session/exercise_kind.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <map>

namespace chiron::session_report {

using namespace report;

namespace {

constexpr std::size_t kHeadlines = 3;

std::vector<MetricRow> rowsOf(const scoring::ScoreCard& card, const catalogue::ExerciseLevel& level, bool felt) {
    std::vector<MetricRow> rows;
    std::size_t headlines = 0;
    for (const scoring::MetricValue& metric : card.metrics) {
        MetricRow row;
        row.id = QString::fromStdString(metric.id);
        row.name = metricName(metric.id);
        row.unit = QString::fromStdString(metric.unit);
        row.value = metric.value;
        row.reason = QString::fromStdString(metric.reason);
        row.passed = metric.passed;
        for (const scoring::Gate& gate : level.gates) {
            if (gate.metric != metric.id)
                continue;
            row.gateMinimum = gate.minimum;
            row.gateMaximum = gate.maximum;
            row.headline = headlines++ < kHeadlines;
        }
        if (felt) // a band is of one device class: these people felt the force
            addPublishedBand(row);
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<ApexError> apexErrorsOf(const scoring::SessionTrace& trace) {
    std::vector<ApexError> errors;
    for (const scoring::TrialTrace& trial : trace.trials) {
        if (!trial.apex || trial.tools.empty() || trial.tools[0].p_WT_m.empty())
            continue;
        ApexError error;
        error.trial = trial.trial;
        error.timedOut = !trial.marked; // the answer that its score counts: where it stood at the end
        const core::Vec3& p = trial.marked ? trial.p_WMark_m : trial.tools[0].p_WT_m.back();
        const double dx = p.x() - trial.apex->x_m;
        const double dy = p.y() - trial.apex->y_m;
        error.x_percent = 100.0 * dx / trial.apex->radius_m;
        error.y_percent = 100.0 * dy / trial.apex->radius_m;
        error.miss = trial.marked && (!trial.markInContact || std::hypot(dx, dy) > trial.apex->radius_m);
        errors.push_back(error);
    }
    return errors;
}

LoopFacts loopFactsOf(const std::string& text) {
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    LoopFacts facts;
    facts.ticks = static_cast<std::uint64_t>(json.value("ticks").toDouble());
    facts.late = static_cast<std::uint64_t>(json.value("late").toDouble());
    facts.realtime = json.value("realtime").toBool();
    facts.p50_us = json.value("p50_us").toDouble();
    facts.p99_us = json.value("p99_us").toDouble();
    facts.max_us = json.value("max_us").toDouble();
    return facts;
}

void addFacts(ReportData& data, const database::SessionRecord& record, const session::SessionSetup& setup,
              const std::string& language) {
    const catalogue::ExerciseLevel& level = setup.level;
    data.simulated = !record.setup.operatorName.empty();
    data.person = QString::fromStdString(record.summary.personName);
    if (data.simulated)
        data.person = QStringLiteral("%1 (scripted), seed %2")
                          .arg(QString::fromStdString(record.setup.operatorName))
                          .arg(record.setup.seed);
    data.demonstration = record.summary.demonstration;
    data.exerciseId = QString::fromStdString(level.exercise);
    data.exerciseTitle = QString::fromStdString(level.exercise).replace(QLatin1Char('_'), QLatin1Char(' '));
    data.levelTitle = QString::fromStdString(catalogue::textIn(level.title, language));
    data.level = level.number;
    data.startedUtc = QDateTime::fromString(QString::fromStdString(record.summary.startedUtc), Qt::ISODateWithMs);
    data.offsetMinutes = record.summary.utcOffset_min;
    data.device = QString::fromStdString(setup.devices.front().model);
    data.felt = record.setup.felt;
    data.state = QString::fromUtf8(database::token(record.summary.state).data());
    data.forceLimit_N = record.setup.forceLimit_N;
    data.loop = loopFactsOf(record.loopJson);
    data.integrity.sessionId = QString::number(record.summary.id);
    data.integrity.frames = record.summary.frames;
    data.integrity.dropped = record.summary.dropped;
    data.integrity.bytes = record.summary.recordingBytes;
    data.integrity.buildId = QString::fromStdString(record.setup.buildId);
    data.integrity.contentSha256 = QString::fromStdString(record.contentSha256);
}

} // namespace

/// P2, "Preliminary Validation": 14.2 % mean, SD 11.3, five subjects with ten hemispheres each.
void addPublishedBand(MetricRow& row) {
    if (row.id != QLatin1String("apex_error_mean"))
        return;
    row.bandLow = 14.2 - 11.3;
    row.bandHigh = 14.2 + 11.3;
    row.bandSource = QStringLiteral("published, 5 subjects × 10");
}

QString metricName(const std::string& id) {
    static const std::map<std::string, const char*> names{
        {"time", "Time"},
        {"path_length", "Path length"},
        {"path_inefficiency", "Path inefficiency"},
        {"sparc", "Smoothness (SPARC)"},
        {"ldlj", "Smoothness (LDLJ)"},
        {"force_max", "Largest force"},
        {"force_mean", "Mean force in contact"},
        {"force_rms", "Force RMS"},
        {"force_p95", "Force, 95th percentile"},
        {"force_peak_rate", "Peak force rate"},
        {"force_impulse_over_limit", "Impulse over the limit"},
        {"force_time_over_limit", "Time over the limit"},
        {"offset_rms", "Off-centre distance, RMS"},
        {"offset_max", "Off-centre distance, largest"},
        {"alignment_rms", "Alignment, RMS"},
        {"bend_alignment", "Alignment at the bend, RMS"},
        {"curve_alignment", "Alignment round the bend, RMS"},
        {"trauma_events", "Trauma events"},
        {"trauma_time", "Time of trauma"},
        {"trauma_impulse", "Impulse of trauma"},
        {"lateral_max", "Largest sideways force"},
        {"advance_while_turning", "Advance while turning"},
        {"torque_max", "Largest torque"},
        {"torque_rms", "Torque RMS"},
        {"reversals", "Reversals"},
        {"landmarks_seen", "Landmarks seen"},
        {"procedure_completed", "Procedure completed"},
        {"inspection_travel", "Tip travel during inspection"},
        {"insertion_depth", "Insertion depth"},
        {"tension_error_rms", "Tension error, RMS"},
        {"tension_error_sd", "Tension error, SD"},
        {"time_in_band", "Time in the band"},
        {"over_stretches", "Over-stretches"},
        {"critical_errors", "Critical errors"},
        {"drops", "Drops"},
        {"squeeze_max", "Largest squeeze"},
        {"squeeze_time_over_limit", "Time squeezed too hard"},
        {"placement_error", "Placement error"},
        {"weighing_correct", "Heaviest found"},
        {"palpation_hits", "Lumps found"},
        {"palpation_misses", "Lumps missed"},
        {"palpation_false_alarms", "False alarms"},
        {"palpation_d_prime", "Sensitivity (d′)"},
        {"palpation_d_prime_low", "Sensitivity, at least"},
        {"palpation_d_prime_high", "Sensitivity, at most"},
        {"palpation_criterion", "Criterion (c)"},
        {"palpation_roc_area", "Area under the ROC"},
        {"localisation_error", "Localisation error"},
        {"size_error", "Size error"},
        {"size_error_by_chance", "Size error by chance"},
        {"hardness_order", "Hardness order"},
        {"coverage", "Area covered"},
        {"force_band_time", "Time in the force band"},
        {"pressing_time", "Time pressing"},
        {"searching_time", "Time searching"},
        {"apex_error_mean", "Apex error, mean"},
        {"apex_error_sd", "Apex error, SD"},
        {"apex_bias_x", "Apex bias, x"},
        {"apex_bias_y", "Apex bias, y"},
        {"apex_misses", "Misses"},
    };
    const auto found = names.find(id);
    return found != names.end() ? QString::fromUtf8(found->second)
                                : QString::fromStdString(id).replace(QLatin1Char('_'), QLatin1Char(' '));
}

core::Result<ReportData> reportHeadOf(const database::SessionRecord& record, const session::SessionSetup& setup,
                                      database::Connection& connection, const database::Actor& actor,
                                      const std::string& language) {
    ReportData data;
    addFacts(data, record, setup, language);
    auto card = database::ScoreRepository(connection, actor).scores(record.summary.id);
    if (card) {
        data.metrics = rowsOf(*card, setup.level, record.setup.felt);
        if (!setup.level.gates.empty())
            data.passed = card->passed;
    } else if (card.error().code != core::ErrorCode::notFound) {
        return tl::unexpected(card.error());
    }
    return data;
}

core::Result<ReportData> reportDataOf(session::StoredSession& session, database::Connection& connection,
                                      const database::Actor& actor, const std::string& language) {
    auto head = reportHeadOf(session.record(), session.setup(), connection, actor, language);
    if (!head)
        return head;
    ReportData data = std::move(*head);
    auto trace = session.trace();
    if (!trace)
        return tl::unexpected(trace.error());
    data.apexErrors = apexErrorsOf(*trace);
    data.insertion = insertionProfileOf(*trace);
    data.palpation = palpationReportOf(*trace, session.setup().level);
    auto series = makeSeries(session, data.integrity.recordingDigest);
    if (!series)
        return tl::unexpected(series.error());
    data.series = std::move(*series);
    data.duration_s = data.series.t_s.empty() ? 0.0 : data.series.t_s.back();
    return data;
}

} // namespace chiron::session_report
