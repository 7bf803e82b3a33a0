// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/session_report/palpation_report.h"

#include "app/exercises/palpation/report/palpation_section.h"

#include <variant>

namespace chiron::session_report {

namespace {

using report::PalpationFindingRow;

PalpationFindingRow rowOf(const scoring::PalpationAnswer& answer, const scoring::FindingMatch& match) {
    const simulation::Finding& finding = answer.findings.list()[static_cast<std::size_t>(match.finding)];
    PalpationFindingRow row;
    row.kind = match.hit() ? PalpationFindingRow::Kind::hit : PalpationFindingRow::Kind::falseAlarm;
    row.number = match.finding + 1;
    row.x_mm = 1e3 * finding.p_W[0];
    row.y_mm = 1e3 * finding.p_W[1];
    row.radius_mm = 1e3 * finding.radius_m;
    row.hardness = finding.hardness;
    row.confidence = finding.confidence;
    if (!match.hit())
        return row;
    row.error_mm = 1e3 * match.distance_m;
    if (finding.radius_m > 0.0)
        row.sizeError_mm =
            1e3 * (finding.radius_m - answer.truth.lumps[static_cast<std::size_t>(match.lump)].radius_m);
    return row;
}

PalpationFindingRow missedRow(const scoring::LumpTruth& lump) {
    PalpationFindingRow row;
    row.kind = PalpationFindingRow::Kind::missed;
    row.x_mm = 1e3 * lump.place_W.x();
    row.y_mm = 1e3 * lump.place_W.y();
    row.radius_mm = 1e3 * lump.radius_m;
    row.hardness = lump.hardness;
    return row;
}

report::PalpationMapFinding drawn(const scoring::PalpationAnswer& answer,
                                  const scoring::FindingMatch& match) {
    const simulation::Finding& finding = answer.findings.list()[static_cast<std::size_t>(match.finding)];
    return {match.finding + 1,
            finding.p_W[0],
            finding.p_W[1],
            finding.radius_m,
            match.hit() ? simulation::FindingOutcome::hit : simulation::FindingOutcome::falseAlarm,
            false};
}

} // namespace

report::PalpationTrialReport palpationTrialOf(const session::PalpationTrialRecord& record,
                                              const simulation::PalpationParameters& level) {
    const scoring::PalpationAnswer& answer = record.answer;
    report::PalpationTrialReport trial;
    trial.trial = record.trial;
    trial.timedOut = record.timedOut;
    trial.map = record.map;
    trial.view.bands = session::mapBandsOf(level);
    trial.view.regionColumns = answer.truth.regionColumns;
    trial.view.regionRows = answer.truth.regionRows;
    for (const scoring::FindingMatch& match : answer.matches) {
        trial.view.findings.push_back(drawn(answer, match));
        trial.rows.push_back(rowOf(answer, match));
    }
    for (std::size_t i = 0; i < answer.truth.lumps.size(); ++i) {
        const scoring::LumpTruth& lump = answer.truth.lumps[i];
        const bool found = scoring::foundBy(answer.matches, static_cast<int>(i)) != nullptr;
        trial.view.lumps.push_back(
            {lump.place_W.x(), lump.place_W.y(), lump.depth_m, lump.radius_m, lump.hardness, found});
        if (!found)
            trial.rows.push_back(missedRow(lump));
    }
    return trial;
}

std::optional<report::PalpationReport> palpationReportOf(const scoring::SessionTrace& trace,
                                                         const catalogue::ExerciseLevel& level) {
    const auto* parameters = level.parameters.find<simulation::PalpationParameters>();
    if (parameters == nullptr)
        return std::nullopt;
    const auto records = session::palpationRecord(trace, *parameters);
    if (!records || records->empty())
        return std::nullopt;
    report::PalpationReport out;
    for (const session::PalpationTrialRecord& record : *records) {
        out.trials.push_back(palpationTrialOf(record, *parameters));
        if (!record.answer.truth.introduction)
            out.regions += scoring::countsOf(record.answer.regions);
    }
    return out;
}

std::shared_ptr<const report::ReportSection> palpationSectionOf(const scoring::SessionTrace& trace,
                                                                const catalogue::ExerciseLevel& level) {
    auto found = palpationReportOf(trace, level);
    return found ? std::make_shared<report::PalpationSection>(std::move(*found)) : nullptr;
}

} // namespace chiron::session_report
