// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "cues/laparoscopy_cues.h"
#include "scoring/median.h"
#include "scoring/metric.h"
#include "scoring/metrics/metric_rows.h"
#include "scoring/metrics/recorded_values.h"
#include "scoring/prepared_trial.h"
#include "scoring/smoothness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace chiron::scoring {

namespace {

Measurement subMovementMedian(std::span<const PreparedTrial> trials, Motion PreparedTrial::*motion,
                              Measurement (*measure)(std::span<const double> speed, double dt_s)) {
    std::vector<double> values;
    bool moved = false;
    for (const PreparedTrial& trial : trials) {
        moved = moved || trial.movementStart_s.has_value();
        const Motion& source = trial.*motion;
        for (const std::span<const double> speed : subMovements(trial, source))
            if (const Measurement m = measure(speed, source.dt_s); m.value)
                values.push_back(*m.value);
    }
    if (!values.empty())
        return Measurement::of(median(std::move(values)));
    return Measurement::undefined(moved ? reasons::kNoSubMovement : reasons::kNoMovement);
}

Measurement measureTime(std::span<const PreparedTrial> trials) {
    double total_s = 0.0;
    bool any = false;
    for (const PreparedTrial& trial : trials) {
        if (!trial.movementStart_s && !trial.contactStart_s)
            continue;
        any = true;
        constexpr double kNever = std::numeric_limits<double>::infinity();
        const double start_s =
            std::min(trial.movementStart_s.value_or(kNever), trial.contactStart_s.value_or(kNever));
        const ToolTrace& tool = *trial.tool;
        for (std::size_t i = 0; i + 1 < tool.t_s.size(); ++i)
            if (!tool.paused[i] && tool.t_s[i + 1] > start_s)
                total_s += tool.t_s[i + 1] - std::max(tool.t_s[i], start_s);
    }
    return any ? Measurement::of(total_s) : Measurement::undefined(reasons::kNeitherMovementNorContact);
}

Measurement measurePathLength(std::span<const PreparedTrial> trials) {
    double length_m = 0.0;
    bool any = false;
    for (const PreparedTrial& trial : trials)
        for (const MotionRun& run : trial.motion.runs)
            for (std::size_t i = 0; i + 1 < run.p_WT_m.size(); ++i) {
                length_m += (run.p_WT_m[i + 1] - run.p_WT_m[i]).norm();
                any = true;
            }
    return any ? Measurement::of(core::mmFromM(length_m)) : Measurement::undefined(reasons::kTooFewPositions);
}

constexpr double kShortest_m = 0.005; // models.md §6: for shorter distances the ratio is meaningless

Measurement measurePathInefficiency(std::span<const PreparedTrial> trials) {
    double sum_percent = 0.0;
    int counted = 0;
    for (const PreparedTrial& trial : trials) {
        double length_m = 0.0;
        core::Vec3 displacement_m =
            core::Vec3::Zero(); // summed per run, because movement during a pause does not count
        for (const MotionRun& run : trial.motion.runs) {
            displacement_m += run.p_WT_m.back() - run.p_WT_m.front();
            for (std::size_t i = 0; i + 1 < run.p_WT_m.size(); ++i)
                length_m += (run.p_WT_m[i + 1] - run.p_WT_m[i]).norm();
        }
        if (displacement_m.norm() < kShortest_m)
            continue;
        sum_percent += 100.0 * (length_m / displacement_m.norm() - 1.0);
        ++counted;
    }
    return counted > 0 ? Measurement::of(sum_percent / counted)
                       : Measurement::undefined(reasons::kEndsTooNear);
}

/// Length of the tip's path, and its progress along a line that it has to follow, in those parts of one trial
/// that follow the line, m.
class PartsOfWay {
public:
    explicit PartsOfWay(const PreparedTrial& trial) : m_trial(trial), m_way(trial.trial->own->way()) {}

    /// Returns 100 (L/D − 1) over these parts, using each only if its progress is at least 5 mm; none if no
    /// part is.
    std::optional<double> percent() {
        double length_m = 0.0, own_m = 0.0;
        for (const std::uint8_t part : m_way.parts) {
            const double own = ownWay_m(part);
            if (own < kShortest_m)
                continue;
            own_m += own;
            length_m += length(part);
        }
        if (own_m < kShortest_m)
            return std::nullopt;
        return 100.0 * (length_m / own_m - 1.0);
    }

private:
    bool is(std::size_t i, std::uint8_t part) const {
        return m_trial.tool->paused[i] == 0 && m_way.part[i] == part;
    }
    double ownWay_m(std::uint8_t part) const {
        std::optional<double> first_m;
        double last_m = 0.0;
        for (std::size_t i = 0; i < m_trial.tool->t_s.size(); ++i)
            if (is(i, part)) {
                last_m = m_way.s_m[i];
                first_m = first_m.value_or(last_m);
            }
        return first_m ? std::abs(last_m - *first_m) : 0.0;
    }
    double length(std::uint8_t part) const {
        double length_m = 0.0;
        std::size_t at = 0;
        const auto now = [&](double t_s) {
            while (at + 1 < m_trial.tool->t_s.size() && m_trial.tool->t_s[at + 1] <= t_s)
                ++at;
            return is(at, part);
        };
        for (const MotionRun& run : m_trial.motion.runs)
            for (std::size_t i = 0; i + 1 < run.p_WT_m.size(); ++i) {
                const bool begins = now(run.t_s[i]);
                if (begins && now(run.t_s[i + 1]))
                    length_m += (run.p_WT_m[i + 1] - run.p_WT_m[i]).norm();
            }
        return length_m;
    }

    const PreparedTrial& m_trial;
    WayAlongLine m_way;
};

/// Length of the tip's path, and the straight distance, in each step of a task that consists of successive
/// steps (grasp, lift, carry ...).
class StepsOfTask {
public:
    StepsOfTask(const PreparedTrial& trial, const QuantityTrace& step) : m_trial(trial), m_step(step) {}

    /// Returns 100 (L/D − 1) over the steps whose ends are at least 5 mm apart, without steps that require a
    /// still hand; none if there is no such step.
    std::optional<double> percent() {
        for (const MotionRun& run : m_trial.motion.runs) { // a pause ends a step
            m_first.reset();
            for (std::size_t i = 0; i < run.p_WT_m.size(); ++i)
                follow(run.p_WT_m[i], stepAt(run.t_s[i]));
            end();
        }
        return m_straight_m > 0.0 ? std::optional(100.0 * (m_length_m / m_straight_m - 1.0)) : std::nullopt;
    }

private:
    double stepAt(double t_s) {
        while (m_at + 1 < m_trial.tool->t_s.size() && m_trial.tool->t_s[m_at + 1] <= t_s)
            ++m_at;
        return m_step.values[m_at];
    }
    void follow(const core::Vec3& p_WT_m, double step) {
        if (m_first && step != m_now)
            end();
        if (!m_first) {
            m_first = m_last = p_WT_m;
            m_now = step;
            m_own_m = 0.0;
        }
        m_own_m += (p_WT_m - m_last).norm();
        m_last = p_WT_m;
    }
    void end() {
        const double straight_m = m_first ? (m_last - *m_first).norm() : 0.0;
        const bool still = m_now == static_cast<double>(core::LaparoscopyStep::hold);
        if (straight_m >= kShortest_m && !still) {
            m_straight_m += straight_m;
            m_length_m += m_own_m;
        }
        m_first.reset();
    }

    const PreparedTrial& m_trial;
    const QuantityTrace& m_step;
    std::size_t m_at = 0;
    std::optional<core::Vec3> m_first; ///< start of the current step
    core::Vec3 m_last = core::Vec3::Zero();
    double m_now = 0.0;
    double m_own_m = 0.0;
    double m_length_m = 0.0;
    double m_straight_m = 0.0;
};

Measurement meanOverTrials(std::span<const PreparedTrial> trials,
                           std::optional<double> (*percentOf)(const PreparedTrial&)) {
    double sum_percent = 0.0;
    int counted = 0;
    for (const PreparedTrial& trial : trials)
        if (const auto percent = percentOf(trial)) {
            sum_percent += *percent;
            ++counted;
        }
    return counted > 0 ? Measurement::of(sum_percent / counted)
                       : Measurement::undefined(reasons::kEndsTooNear);
}

/// Along a line that has to be followed (a canal) this uses its parts, elsewhere version 1.
Measurement measurePathInefficiency2(std::span<const PreparedTrial> trials) {
    const auto alongLine = [](const PreparedTrial& trial) {
        return trial.tool != nullptr && trial.trial->own && !trial.trial->own->way().parts.empty();
    };
    if (trials.empty() || !std::all_of(trials.begin(), trials.end(), alongLine))
        return measurePathInefficiency(trials);
    return meanOverTrials(trials, [](const PreparedTrial& trial) { return PartsOfWay(trial).percent(); });
}

/// In a task with steps this uses the steps, elsewhere version 2.
Measurement measurePathInefficiency3(std::span<const PreparedTrial> trials) {
    const auto inSteps = [](const PreparedTrial& trial) { return quantityOf(trial, "step") != nullptr; };
    if (trials.empty() || !std::all_of(trials.begin(), trials.end(), inSteps))
        return measurePathInefficiency2(trials);
    return meanOverTrials(trials, [](const PreparedTrial& trial) {
        return StepsOfTask(trial, *quantityOf(trial, "step")).percent();
    });
}

Measurement measureSparc(std::span<const PreparedTrial> trials) {
    return subMovementMedian(trials, &PreparedTrial::motion, spectralArcLength);
}

Measurement measureLdlj(std::span<const PreparedTrial> trials) {
    return subMovementMedian(trials, &PreparedTrial::jerkMotion, logDimensionlessJerk);
}

} // namespace

std::vector<MetricDefinition> motionMetrics() {
    MetricRows rows;
    rows.add(
        {.id = "time",
         .unit = "s",
         .wrench = MetricWrench::tissue,
         .aggregate = Aggregate::sum,
         .title = QT_TRANSLATE_NOOP("Metrics", "Time"),
         .meaning = QT_TRANSLATE_NOOP(
             "Metrics",
             "From the first movement or touch of each trial to its end, added up; pauses do not count."),
         .definition = "From the first movement (50 ms above 5 mm/s) or contact (0.02 N), whichever is "
                       "earlier, to the trial's end, without "
                       "pauses.",
         .source = "models.md §6",
         .measure = measureTime});
    rows.add({.id = "path_length",
              .unit = "mm",
              .aggregate = Aggregate::sum,
              .title = QT_TRANSLATE_NOOP("Metrics", "Path length"),
              .meaning = QT_TRANSLATE_NOOP("Metrics",
                                           "How far the tip of the tool travelled in all trials together."),
              .definition = "Sum of |dp| of the tool tip, low-passed at 20 Hz and at 100 Hz.",
              .source = "models.md §6",
              .measure = measurePathLength});
    rows.add(
        {.id = "path_inefficiency",
         .unit = "%",
         .title = QT_TRANSLATE_NOOP("Metrics", "Path inefficiency"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "How much longer the path was than the shortest one: the "
                                                 "straight line or, where the route bends, the route itself; "
                                                 "the mean over the trials."),
         .definition = "100 (L/D - 1), D the straight distance between the trial's ends; the mean over the "
                       "trials where D is at least 5 mm.",
         .source = "models.md §6",
         .measure = measurePathInefficiency});
    rows.next({.definition = "100 (L/D - 1). In a canal of the stages insertion and withdrawal together: L "
                             "the tip's path, D its way along the "
                             "centre-line, stages of at least 5 mm. Elsewhere D is the straight distance "
                             "between the trial's ends; the mean over "
                             "the trials where D is at least 5 mm.",
               .source = "models.md §6 and §8",
               .measure = measurePathInefficiency2});
    rows.next({.definition =
                   "100 (L/D - 1). In a task of recorded steps (grasp, lift, carry ...): L the tip's path "
                   "and D the straight distance, "
                   "both added up over the unbroken stretches of one step whose ends are at least 5 mm "
                   "apart, without holding still. In a "
                   "canal of the stages insertion and withdrawal together: D the tip's way along the "
                   "centre-line. Elsewhere D is the "
                   "straight distance between the trial's ends. The mean over the trials that have such a D.",
               .measure = measurePathInefficiency3});
    rows.add({.id = "sparc",
              .unit = "",
              .direction = Direction::higherIsBetter,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Smoothness (SPARC)"),
              .meaning = QT_TRANSLATE_NOOP("Metrics", "How even the speed of each movement was, calculated "
                                                      "from its spectrum. Closer to zero is smoother."),
              .definition = "Median over the sub-movements (speed over 5 % of its peak for 100 ms) of their "
                            "spectral arc length.",
              .source = "models.md §6; Balasubramanian et al. 2015, J NeuroEng Rehabil 12:112",
              .measure = measureSparc});
    rows.add({.id = "ldlj",
              .unit = "",
              .direction = Direction::higherIsBetter,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Smoothness (LDLJ)"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics", "How free of jerks each movement was. Closer to zero is smoother."),
              .definition = "Median over the sub-movements (speed over 5 % of its peak for 100 ms) of their "
                            "log dimensionless jerk, low-passed at "
                            "6 Hz.",
              .source = "models.md §6; Balasubramanian et al. 2015, J NeuroEng Rehabil 12:112",
              .measure = measureLdlj});
    return rows.take();
}

} // namespace chiron::scoring
