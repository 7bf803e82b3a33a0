// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/scoring/findings_trace.h"

#include <array>
#include <cmath>
#include <string_view>

namespace chiron::scoring {

namespace {

constexpr std::array<std::string_view, 7> kColumns{"report_count", "report_field", "report_finding",
                                                   "report_value", "finding_x_m",  "finding_y_m",
                                                   "finding_z_m"};
constexpr double kMostCounted = 1e6; ///< no trial has this many reports

using Columns = std::array<const std::vector<double>*, kColumns.size()>;

std::optional<Columns> columnsOf(const TrialTrace& trial) {
    if (trial.tools.empty())
        return std::nullopt;
    Columns columns{};
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
        for (const QuantityTrace& quantity : trial.quantities)
            if (quantity.id == kColumns[i] && quantity.values.size() == trial.tools.front().t_s.size())
                columns[i] = &quantity.values;
        if (columns[i] == nullptr)
            return std::nullopt;
    }
    return columns;
}

/// Rounds to a whole number in [low, high]; none outside, because a trace file may contain any number.
std::optional<int> whole(double value, int low, int high) {
    const double rounded = std::round(value);
    return rounded >= low && rounded <= high ? std::optional(static_cast<int>(rounded)) : std::nullopt;
}

std::optional<TimedReport> reportAt(const Columns& columns, std::size_t i, double t_s) {
    const auto at = [&](std::size_t column) { return (*columns[column])[i]; };
    const auto field = whole(at(1), 0, static_cast<int>(simulation::ReportField::done));
    const auto value = whole(at(3), 0, simulation::kReportValueMask);
    if (!field || !value)
        return std::nullopt;
    TimedReport report{t_s, static_cast<simulation::ReportField>(*field), simulation::FindingsBook::kNone,
                       static_cast<unsigned>(*value), core::Vec3(at(4), at(5), at(6))};
    if (report.field == simulation::ReportField::done)
        return report;
    const auto finding = whole(at(2), 0, static_cast<int>(simulation::kMaxFindings) - 1);
    if (!finding || !report.place_W.allFinite())
        return std::nullopt;
    report.finding = *finding;
    return report;
}

void take(simulation::FindingsBook& book, const TimedReport& report) {
    switch (report.field) {
    case simulation::ReportField::found:
        book.place(report.finding, {report.place_W.x(), report.place_W.y(), report.place_W.z()});
        return;
    case simulation::ReportField::remove:
        book.remove(report.finding);
        return;
    case simulation::ReportField::select:
        book.report(simulation::ReportField::select, static_cast<unsigned>(report.finding));
        return;
    case simulation::ReportField::done:
        book.report(simulation::ReportField::done, 0);
        return;
    case simulation::ReportField::size:
    case simulation::ReportField::hardness:
    case simulation::ReportField::confidence:
        book.rate(report.finding, report.field, report.value);
        return;
    }
}

} // namespace

std::optional<ReportsOfTrial> reportsOf(const TrialTrace& trial) {
    const auto columns = columnsOf(trial);
    if (!columns)
        return std::nullopt;
    ReportsOfTrial out;
    double counted = 0.0;
    for (std::size_t i = 0; i < (*columns)[0]->size(); ++i) {
        const double count = std::round((*(*columns)[0])[i]);
        if (!(count > counted) || count > kMostCounted)
            continue;
        const auto report = reportAt(*columns, i, trial.tools.front().t_s[i]);
        // Of several reports only the last is recorded.
        out.lost += static_cast<int>(count - counted) - (report ? 1 : 0);
        if (report)
            out.reports.push_back(*report);
        counted = count;
    }
    return out;
}

simulation::FindingsBook findingsAfter(std::span<const TimedReport> reports, double until_s) {
    simulation::FindingsBook book;
    for (const TimedReport& report : reports)
        if (report.t_s <= until_s)
            take(book, report);
    return book;
}

} // namespace chiron::scoring
