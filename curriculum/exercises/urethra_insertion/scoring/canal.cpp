// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/urethra_insertion/scoring/canal_metrics.h"

#include "core/units.h"
#include "curriculum/exercises/urethra_insertion/scoring/canal_reasons.h"
#include "curriculum/exercises/urethra_insertion/scoring/canal_samples.h"
#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"
#include "modules/exercises/urethra_insertion/cues/canal_reach.h"
#include "scoring/metrics/metric_rows.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureOffsetRms(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    RootMeanSquare offset_m;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) {
        if (isInUrethra(series, i))
            offset_m.add(series.offset_m[i]);
    });
    return offset_m.empty() ? neverInUrethra() : Measurement::of(core::mmFromM(offset_m.value()));
}

Measurement measureOffsetMax(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double largest_m = -1.0;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) {
        if (isInUrethra(series, i))
            largest_m = std::max(largest_m, series.offset_m[i]);
    });
    return largest_m < 0.0 ? neverInUrethra() : Measurement::of(core::mmFromM(largest_m));
}

Measurement measureAlignmentRms(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    RootMeanSquare angle_rad;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) {
        if (isInUrethra(series, i))
            angle_rad.add(series.alignment_rad[i]);
    });
    return angle_rad.empty() ? neverInUrethra() : Measurement::of(core::degFromRad(angle_rad.value()));
}

Measurement measureBendAlignment(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    RootMeanSquare angle_rad;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) {
        if (isStage(series, i, simulation::ProcedureStage::insertion) && isAtBend(series, i))
            angle_rad.add(series.alignment_rad[i]);
    });
    return angle_rad.empty() ? Measurement::undefined(reasons::kNeverAtBend)
                             : Measurement::of(core::degFromRad(angle_rad.value()));
}

Measurement measureCurveAlignment(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    RootMeanSquare angle_rad;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) {
        if (isStage(series, i, simulation::ProcedureStage::insertion) && isInCurve(series, i))
            angle_rad.add(series.alignment_rad[i]);
    });
    return angle_rad.empty() ? Measurement::undefined(reasons::kNeverAtBend)
                             : Measurement::of(core::degFromRad(angle_rad.value()));
}

/// The rate of turning is measured over twice this time, two periods of a 10 Hz tremor.
constexpr double kHalfWindow_s = 0.1;
/// About half of the rate needed at B to follow P1's parabola at 6 mm/s, 9°/s.
constexpr double kTurning_rad_per_s = 5.0 * core::kPi / 180.0;

core::Vec3 axisOf(const ToolTrace& tool, std::size_t i) {
    return tool.q_WT[i] * core::Vec3::UnitZ();
}

/// Measures how far the tip reached new depth in the curve while the axis turned, m. `reached` is set if the
/// tip was in the curve.
class TurningAdvance {
public:
    explicit TurningAdvance(const TrialTrace& trial)
        : m_tool(trial.tools.front()), m_series(*insertionOf(trial)) {}

    double measure(bool& reached) {
        double advance_m = 0.0, deepest_m = m_series.bend_m;
        for (std::size_t i = 0; i < m_tool.t_s.size(); ++i) {
            if (m_tool.paused[i] != 0 || !isStage(m_series, i, simulation::ProcedureStage::insertion) ||
                m_series.s_m[i] < m_series.bend_m)
                continue;
            reached = true;
            const double depth_m = std::min(m_series.s_m[i], m_series.bend_m + kCurve_m);
            if (depth_m > deepest_m && turns(i))
                advance_m += depth_m - deepest_m;
            deepest_m = std::max(deepest_m, depth_m);
        }
        return advance_m;
    }

private:
    bool turns(std::size_t i) {
        const double t_s = m_tool.t_s[i];
        while (m_tool.t_s[m_from] < t_s - kHalfWindow_s)
            ++m_from;
        while (m_to + 1 < m_tool.t_s.size() && m_tool.t_s[m_to] < t_s + kHalfWindow_s)
            ++m_to;
        const double time_s = m_tool.t_s[m_to] - m_tool.t_s[m_from];
        const core::Vec3 before = axisOf(m_tool, m_from), after = axisOf(m_tool, m_to);
        return time_s > 0.0 &&
               std::atan2(before.cross(after).norm(), before.dot(after)) > kTurning_rad_per_s * time_s;
    }

    const ToolTrace& m_tool;
    const InsertionSeries& m_series;
    std::size_t m_from = 0, m_to = 0;
};

Measurement measureAdvanceWhileTurning(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    bool reached = false;
    double advance_m = 0.0;
    for (const PreparedTrial& trial : trials) {
        if (trial.tool->q_WT.size() != trial.tool->t_s.size())
            return Measurement::undefined(reasons::kNoInsertionData);
        advance_m += TurningAdvance(*trial.trial).measure(reached);
    }
    return reached ? Measurement::of(core::mmFromM(advance_m))
                   : Measurement::undefined(reasons::kNeverAtBend);
}

Measurement measureTraumaEvents(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials)
        count += insertionEvents(*trial.trial).trauma.size();
    return Measurement::of(static_cast<double>(count));
}

Measurement measureTraumaTime(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double time_s = 0.0;
    for (const PreparedTrial& trial : trials)
        for (const InsertionEvent& event : insertionEvents(*trial.trial).trauma)
            time_s += event.end_s - event.begin_s;
    return Measurement::of(time_s);
}

Measurement measureTraumaImpulse(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double impulse_Ns = 0.0;
    for (const PreparedTrial& trial : trials) {
        const ToolTrace& tool = *trial.tool;
        const InsertionSeries& series = *insertionOf(*trial.trial);
        for (std::size_t i = 0; i + 1 < tool.t_s.size(); ++i)
            if (tool.paused[i] == 0 && series.lateral_N[i] > series.lateralLimit_N)
                impulse_Ns += series.lateral_N[i] * (tool.t_s[i + 1] - tool.t_s[i]);
    }
    return Measurement::of(impulse_Ns);
}

Measurement measureLateralMax(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double most_N = 0.0;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) {
        most_N = std::max(most_N, series.lateral_N[i]);
    });
    return Measurement::of(most_N);
}

Measurement measureReversals(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials)
        count += insertionEvents(*trial.trial).reversals.size();
    return Measurement::of(static_cast<double>(count));
}

Measurement measureLandmarksSeen(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    std::size_t asked = 0;
    std::size_t seen = 0;
    for (const PreparedTrial& trial : trials)
        for (const double seen_s : insertionOf(*trial.trial)->landmarkSeen_s) {
            ++asked;
            seen += std::isnan(seen_s) ? 0 : 1;
        }
    return asked == 0 ? Measurement::undefined(reasons::kNoLandmarks)
                      : Measurement::of(100.0 * static_cast<double>(seen) / static_cast<double>(asked));
}

/// Finds the stage at a time. The times asked for must be in ascending or nearly ascending order.
class StageAt {
public:
    StageAt(const ToolTrace& tool, const InsertionSeries& series) : m_tool(tool), m_series(series) {}
    /// Uses the last sample at or before `t_s`.
    bool inspects(double t_s) {
        while (m_at + 1 < m_tool.t_s.size() && m_tool.t_s[m_at + 1] <= t_s)
            ++m_at;
        return isStage(m_series, m_at, simulation::ProcedureStage::inspection);
    }

private:
    const ToolTrace& m_tool;
    const InsertionSeries& m_series;
    std::size_t m_at = 0;
};

Measurement measureInspectionTravel(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double travel_m = 0.0;
    bool asked = false;
    bool any = false;
    for (const PreparedTrial& trial : trials) {
        asked = asked || !insertionOf(*trial.trial)->landmarkSeen_s.empty();
        StageAt stageAt(*trial.tool, *insertionOf(*trial.trial));
        for (const MotionRun& run : trial.motion.runs)
            for (std::size_t i = 0; i + 1 < run.p_WT_m.size(); ++i) {
                const bool inspects = stageAt.inspects(run.t_s[i]);
                if (!inspects || !stageAt.inspects(run.t_s[i + 1]))
                    continue;
                any = true;
                travel_m += (run.p_WT_m[i + 1] - run.p_WT_m[i]).norm();
            }
    }
    if (any)
        return Measurement::of(core::mmFromM(travel_m));
    return Measurement::undefined(asked ? reasons::kInspectionNotReached : reasons::kNoLandmarks);
}

Measurement measureInsertionDepth(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double sum_mm = 0.0;
    for (const PreparedTrial& trial : trials) {
        double deepest_m = 0.0; // stays 0 if the tip never entered
        forEachCanalSample({&trial, 1}, [&](const InsertionSeries& series, std::size_t i) {
            if (series.offset_m[i] <= simulation::kCanalReach_m) // a tip beside the canal is not in it
                deepest_m = std::max(deepest_m, std::min(series.s_m[i], series.goal_m));
        });
        sum_mm += std::nearbyint(deepest_m * 1e9) / 1e6; // rounded, so that a gate at the goal is met
    }
    return Measurement::of(sum_mm / static_cast<double>(trials.size()));
}

} // namespace

std::vector<MetricDefinition> canalMetrics() {
    MetricRows rows;
    rows.add(
        {.id = "offset_rms",
         .unit = "mm",
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Off-centre distance, root mean square"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "How far the tip was from the middle of the urethra, on the "
                                                 "way in and out: large distances weigh more than in the "
                                                 "mean."),
         .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Largest off-centre distance"),
         .definition = "Root mean square of the tip's distance from the centre-line over the samples in the "
                       "urethra (0 <= s <= L), on the way "
                       "in and out.",
         .source = "models.md §6, insertion",
         .measure = measureOffsetRms});
    rows.add({.id = "offset_max",
              .unit = "mm",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Largest off-centre distance"),
              .meaning = QT_TRANSLATE_NOOP("Metrics",
                                           "The largest distance of the tip from the middle of the urethra."),
              .definition = "Largest distance of the tip from the centre-line in the urethra (0 <= s <= L), "
                            "on the way in and out.",
              .source = "models.md §6, insertion",
              .measure = measureOffsetMax});
    rows.add({.id = "alignment_rms",
              .unit = "°",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Alignment, root mean square"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics", "The angle between the endoscope and the direction of the urethra where its "
                             "tip was; large angles weigh more. In the picture: when the two are in line, "
                             "the wall near the tip is equally wide all round, and a guide ring, where "
                             "there is one, is drawn double. In a bend the urethra then continues beside "
                             "the middle of the picture."),
              .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Largest misalignment"),
              .definition = "Root mean square of the angle between the instrument's axis and the "
                            "centre-line's tangent over the samples in the "
                            "urethra (0 <= s <= L), on the way in and out.",
              .source = "models.md §6, insertion",
              .measure = measureAlignmentRms});
    rows.add({.id = "bend_alignment",
              .unit = "°",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Alignment at the bend"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics", "The angle between the endoscope and the urethra at its tip, on the way in, "
                             "within 10 mm of the bend, where the endoscope has to be turned. When the two "
                             "are in line, the wall near the tip is equally wide all round."),
              .definition = "Root mean square of the angle between the instrument's axis and the "
                            "centre-line's tangent over the samples of the "
                            "insertion within 10 mm of the bend (s_B), where the orientation has to change.",
              .source = "models.md §6, insertion; P1, point B",
              .measure = measureBendAlignment});
    rows.add({.id = "curve_alignment",
              .unit = "°",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Alignment in the bend"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics", "The angle between the endoscope and the urethra at its tip, on the way in, "
                             "from the bend to 30 mm past it, where the urethra is curved most. When the two "
                             "are in line, the wall near the tip is equally wide all round."),
              .definition = "Root mean square of the angle between the instrument's axis and the "
                            "centre-line's tangent over the samples of the "
                            "insertion from the bend B to 30 mm past it, where the canal is curved most.",
              .source = "models.md §6, insertion, and §8; P1, point B",
              .measure = measureCurveAlignment});
    rows.add(
        {.id = "advance_while_turning",
         .unit = "mm",
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Advance while turning"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "How far the endoscope was pushed on in the bend while it "
                                                 "was being turned: stop, turn, and only then go on."),
         .definition = "How far the tip got deeper, in the stage insertion and up to 30 mm past the bend B, "
                       "while the instrument's axis "
                       "turned faster than 5 degrees per second, taken over 0.2 s: at B the orientation "
                       "changes without translation.",
         .source = "P1, point B; models.md §8",
         .measure = measureAdvanceWhileTurning});
    rows.add({.id = "trauma_events",
              .unit = "count",
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Trauma events"),
              .meaning = QT_TRANSLATE_NOOP("Metrics", "How often the endoscope pressed sideways on the wall "
                                                      "over the limit of this level for 20 ms or longer. "
                                                      "Each time is a trauma event: it may injure the wall."),
              .definition = "How often the force across the canal was over the level's lateral limit for 20 "
                            "ms or longer, to begin again only from "
                            "below 80 % of it. It is the whole tissue force without its part along the "
                            "centre-line's tangent at the tip: the "
                            "wall's push, and of friction along a tilted shaft the part that lies across.",
              .source = "models.md §6, insertion",
              .measure = measureTraumaEvents});
    rows.add({.id = "trauma_time",
              .unit = "s",
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Trauma time"),
              .meaning = QT_TRANSLATE_NOOP("Metrics", "How long these events lasted in total."),
              .definition = "How long the trauma events lasted in all, each from the first sample over the "
                            "lateral limit until the "
                            "force across the canal was below 80 % of it.",
              .source = "models.md §6, insertion",
              .measure = measureTraumaTime});
    rows.add({.id = "trauma_impulse",
              .unit = "N·s",
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Trauma impulse"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics", "Sideways force times time while that force was over the limit of this level."),
              .definition = "Integral of the force across the canal while it is over the lateral limit, each "
                            "sample held until the next.",
              .source = "models.md §6, insertion",
              .measure = measureTraumaImpulse});
    rows.add({.id = "lateral_max",
              .unit = "N",
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Largest sideways force"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics",
                  "The largest force with which the endoscope pressed sideways on the wall at any moment."),
              .definition = "The largest force across the canal of any sample.",
              .source = "models.md §6, insertion",
              .measure = measureLateralMax});
    rows.add({.id = "reversals",
              .unit = "count",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Reversals"),
              .meaning =
                  QT_TRANSLATE_NOOP("Metrics", "How often the tip went back by 1 mm or more on the way in."),
              .definition = "How often the tip went back by 1 mm or more along the centre-line during the "
                            "insertion; a way back ends where the tip "
                            "has turned forward by 1 mm.",
              .source = "models.md §6, insertion",
              .measure = measureReversals});
    rows.add(
        {.id = "landmarks_seen",
         .unit = "%",
         .direction = Direction::higherIsBetter,
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Landmarks seen"),
         .meaning = QT_TRANSLATE_NOOP(
             "Metrics",
             "The landmarks of the bladder that were inspected, in % of those that the level asks for."),
         .wholly = QT_TRANSLATE_NOOP("Metrics", "All landmarks are seen"),
         .definition = "Landmarks of the bladder that were inspected, in % of those that the level asks for.",
         .source = "models.md §1.3, §6",
         .measure = measureLandmarksSeen});
    rows.add({.id = "inspection_travel",
              .unit = "mm",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Tip travel during inspection"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics", "How far the tip travelled while the bladder was inspected: turning the "
                             "endoscope shows as much and does less harm."),
              .definition = "Sum of |dp| of the tip while the bladder is inspected, low-passed at 20 Hz and "
                            "at 100 Hz: a tip that is turned, not "
                            "moved, sees as much.",
              .source = "models.md §1.3, §6",
              .measure = measureInspectionTravel});
    rows.add({.id = "insertion_depth",
              .unit = "mm",
              .direction = Direction::higherIsBetter,
              .title = QT_TRANSLATE_NOOP("Metrics", "Insertion depth"),
              .meaning = QT_TRANSLATE_NOOP("Metrics",
                                           "How deep the tip went, counted up to the goal of this level."),
              .definition = "The deepest place that the tip reached along the centre-line, no farther than "
                            "10 mm beside it, at most the level's "
                            "goal; the mean over the trials.",
              .source = "models.md §1.3",
              .measure = measureInsertionDepth});
    return rows.take();
}

} // namespace chiron::scoring
