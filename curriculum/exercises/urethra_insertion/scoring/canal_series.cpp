// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/urethra_insertion/scoring/canal_series.h"

#include "scoring/trace_columns.h"
#include "scoring/trace_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace chiron::scoring {

namespace {

using simulation::ProcedureStage;

constexpr double kFurthest_mm = 1e6;
constexpr double kStrongest_N = 1e6;
constexpr double kStrongest_mNm = 1e6;
constexpr double kMostBits = 4294967295.0;
constexpr std::string_view kDistanceText = "millimetres, 0 to 1e6";
constexpr std::array<std::string_view, 5> kStageNames{"outside", "insertion", "inspection", "withdrawal",
                                                      "completed"};
/// The shared columns that those of a canal follow in a file: its samples, its trial, and what came later.
constexpr std::string_view kAfterTorque = "tz_mNm", kAfterPlanned = "trials_planned",
                           kAfterContact = "contact";

// clang-format off
constexpr auto kColumns = std::to_array<OwnColumn>({
    {"arc_mm", ColumnKind::length, -kFurthest_mm, kFurthest_mm, "millimetres, -1e6 to 1e6", kAfterTorque},
    {"offset_mm", ColumnKind::length, 0.0, kFurthest_mm, kDistanceText, kAfterTorque},
    {"alignment_deg", ColumnKind::fineAngle, 0.0, 180.0, "degrees, 0 to 180", kAfterTorque},
    {"lateral_N", ColumnKind::force, 0.0, kStrongest_N, "newtons, 0 to 1e6", kAfterTorque},
    {"axial_mNm", ColumnKind::torque, 0.0, kStrongest_mNm, "millinewton metres, 0 to 1e6", kAfterTorque},
    {"stage", ColumnKind::word, 0.0, 4.0, "outside, insertion, inspection, withdrawal or completed", kAfterTorque, false, kStageNames},
    {"landmarks_seen", ColumnKind::integer, 0.0, kMostBits, "a whole number, 0 to 4294967295: one bit a landmark", kAfterTorque},
    {"length_mm", ColumnKind::length, 1e-6, kFurthest_mm, "millimetres, 1e-6 to 1e6", kAfterPlanned, true},
    {"bend_mm", ColumnKind::length, 0.0, kFurthest_mm, kDistanceText, kAfterPlanned, true},
    {"goal_mm", ColumnKind::length, 0.0, kFurthest_mm, kDistanceText, kAfterPlanned, true},
    {"lateral_limit_N", ColumnKind::force, 0.001, kStrongest_N, "newtons, 0.001 to 1e6", kAfterPlanned, true},
    {"landmarks", ColumnKind::integer, 0.0, 32.0, "a whole number, 0 to 32", kAfterContact, true},
});
// clang-format on

/// The places of the columns in TraceRow::own.
struct Place {
    enum : std::size_t {
        arc,
        offset,
        alignment,
        lateral,
        axial,
        stageOf,
        seen,
        length,
        bend,
        goal,
        lateralLimit,
        landmarks,
        count
    };
};
static_assert(kColumns.size() == Place::count && kColumns[Place::seen].name == "landmarks_seen" &&
              kColumns[Place::landmarks].name == "landmarks");

double seenOnGrid(double seen_s, std::span<const double> t_s) {
    const auto first = std::lower_bound(t_s.begin(), t_s.end(), onMicroseconds(seen_s));
    const bool reached = std::isfinite(seen_s) && first != t_s.end();
    return reached ? *first : std::numeric_limits<double>::quiet_NaN();
}

std::shared_ptr<const OwnTrace> seriesOf(const TraceRow& first, std::span<const TraceRow* const> rows) {
    auto series = std::make_shared<InsertionSeries>();
    series->length_m = first.own[Place::length];
    series->bend_m = first.own[Place::bend];
    series->goal_m = first.own[Place::goal];
    series->lateralLimit_N = first.own[Place::lateralLimit];
    series->landmarkSeen_s.assign(static_cast<std::size_t>(first.own[Place::landmarks]),
                                  std::numeric_limits<double>::quiet_NaN());
    for (const TraceRow* row : rows) {
        const std::vector<double>& own = row->own;
        series->s_m.push_back(own[Place::arc]);
        series->offset_m.push_back(own[Place::offset]);
        series->alignment_rad.push_back(own[Place::alignment]);
        series->lateral_N.push_back(own[Place::lateral]);
        series->axialTorque_Nm.push_back(own[Place::axial]);
        series->stage.push_back(static_cast<std::uint8_t>(own[Place::stageOf]));
        const auto bits = static_cast<std::uint32_t>(own[Place::seen]);
        for (std::size_t k = 0; k < series->landmarkSeen_s.size(); ++k)
            if (std::isnan(series->landmarkSeen_s[k]) && (bits >> k & 1u) != 0)
                series->landmarkSeen_s[k] = row->t_s;
    }
    return series;
}

constexpr OwnColumns kCanal{"a canal", kColumns, &TraceColumns::completed, true, &seriesOf};

} // namespace

bool InsertionSeries::fits(std::size_t samples) const noexcept {
    return s_m.size() == samples && offset_m.size() == samples && alignment_rad.size() == samples &&
           lateral_N.size() == samples && axialTorque_Nm.size() == samples && stage.size() == samples;
}

bool InsertionSeries::finiteAt(std::size_t i) const noexcept {
    return std::isfinite(s_m[i]) && std::isfinite(offset_m[i]) && std::isfinite(alignment_rad[i]) &&
           std::isfinite(lateral_N[i]) && std::isfinite(axialTorque_Nm[i]);
}

core::Result<std::shared_ptr<const OwnTrace>> InsertionSeries::onGrids(std::span<const std::size_t> kept,
                                                                       std::span<const double> t_s) const {
    if (landmarkSeen_s.size() > kMostLandmarks)
        return core::fail(core::ErrorCode::badInput,
                          "trace: more than 32 landmarks: expected what a trace file can hold");
    auto out = std::make_shared<InsertionSeries>();
    for (const std::size_t i : kept) {
        out->s_m.push_back(onNanometres(s_m[i]));
        out->offset_m.push_back(onNanometres(offset_m[i]));
        out->alignment_rad.push_back(onMicrodegrees(alignment_rad[i]));
        out->lateral_N.push_back(onMillinewtons(lateral_N[i]));
        out->axialTorque_Nm.push_back(onTorqueGrid(axialTorque_Nm[i]));
        out->stage.push_back(stage[i]);
    }
    out->length_m = onNanometres(length_m);
    out->bend_m = onNanometres(bend_m);
    out->goal_m = onNanometres(goal_m);
    out->lateralLimit_N = onMillinewtons(lateralLimit_N);
    for (const double seen_s : landmarkSeen_s)
        out->landmarkSeen_s.push_back(seenOnGrid(seen_s, t_s));
    return out;
}

const OwnColumns& InsertionSeries::columns() const noexcept {
    return kCanal;
}

void InsertionSeries::fillTrial(std::span<double> own) const noexcept {
    own[Place::length] = length_m;
    own[Place::bend] = bend_m;
    own[Place::goal] = goal_m;
    own[Place::lateralLimit] = lateralLimit_N;
    own[Place::landmarks] = static_cast<double>(landmarkSeen_s.size());
}

void InsertionSeries::fillSample(std::span<double> own, std::size_t i, double t_s) const noexcept {
    own[Place::arc] = s_m[i];
    own[Place::offset] = offset_m[i];
    own[Place::alignment] = alignment_rad[i];
    own[Place::lateral] = lateral_N[i];
    own[Place::axial] = axialTorque_Nm[i];
    own[Place::stageOf] = stage[i];
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < landmarkSeen_s.size(); ++k)
        if (landmarkSeen_s[k] <= t_s) // NaN if it was not seen
            bits |= 1u << k;
    own[Place::seen] = bits;
}

WayAlongLine InsertionSeries::way() const noexcept {
    static constexpr std::array kParts{static_cast<std::uint8_t>(ProcedureStage::insertion),
                                       static_cast<std::uint8_t>(ProcedureStage::withdrawal)};
    return {s_m, stage, kParts};
}

const OwnColumns& canalColumns() noexcept {
    return kCanal;
}

std::string_view stageName(ProcedureStage stage) noexcept {
    return kStageNames[std::min<std::size_t>(static_cast<std::size_t>(stage), kStageNames.size() - 1)];
}

} // namespace chiron::scoring
