// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/prepared_trial.h"

#include "scoring/low_pass.h"

#include <algorithm>
#include <cmath>

namespace chiron::scoring {

namespace {

using Microseconds = std::int64_t;

constexpr Microseconds kSlowStep = 9500; ///< from this step on, a trace is "slower than 100 Hz"
constexpr Microseconds kDecimated = 10000;
constexpr int kGapSteps = 100;
constexpr double kMotionCutOff_Hz = 20.0;
constexpr double kJerkCutOff_Hz = 6.0;

struct Samples {
    std::vector<Microseconds> t;
    std::vector<core::Vec3> p;
};

Microseconds microseconds(double t_s) {
    return static_cast<Microseconds>(std::llround(t_s * 1e6));
}
double seconds(Microseconds t) {
    return static_cast<double>(t) / 1e6;
}

Microseconds medianStep(const ToolTrace& tool) {
    std::vector<Microseconds> steps;
    for (std::size_t i = 1; i < tool.t_s.size(); ++i)
        if (!tool.paused[i] && !tool.paused[i - 1])
            steps.push_back(microseconds(tool.t_s[i]) - microseconds(tool.t_s[i - 1]));
    if (steps.empty())
        return kDecimated;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

std::vector<Samples> unpausedRuns(const ToolTrace& tool, Microseconds step) {
    std::vector<Samples> runs;
    bool open = false;
    for (std::size_t i = 0; i < tool.t_s.size(); ++i) {
        if (tool.paused[i]) {
            open = false;
            continue;
        }
        const Microseconds t = microseconds(tool.t_s[i]);
        if (!open || t - runs.back().t.back() > kGapSteps * step)
            runs.emplace_back();
        open = true;
        runs.back().t.push_back(t);
        runs.back().p.push_back(tool.p_WT_m[i]);
    }
    return runs;
}

/// Interpolates linearly between samples. At a grid time that coincides with a sample, the result is exactly
/// that sample.
Samples onEvenGrid(const Samples& in, Microseconds step) {
    Samples out;
    std::size_t i = 0;
    for (Microseconds t = in.t.front(); t <= in.t.back(); t += step) {
        while (i + 1 < in.t.size() && in.t[i + 1] <= t)
            ++i;
        core::Vec3 p = in.p[i];
        if (t > in.t[i]) {
            const double share =
                static_cast<double>(t - in.t[i]) / static_cast<double>(in.t[i + 1] - in.t[i]);
            p += share * (in.p[i + 1] - in.p[i]);
        }
        out.t.push_back(t);
        out.p.push_back(p);
    }
    return out;
}

MotionRun withSpeed(Samples&& samples) {
    MotionRun run;
    run.p_WT_m = std::move(samples.p);
    for (const Microseconds t : samples.t)
        run.t_s.push_back(seconds(t));
    for (std::size_t i = 1; i < samples.t.size(); ++i)
        run.speed_m_per_s.push_back((run.p_WT_m[i] - run.p_WT_m[i - 1]).norm() /
                                    seconds(samples.t[i] - samples.t[i - 1]));
    return run;
}

std::optional<double> movementStart(const Motion& motion) {
    for (const MotionRun& run : motion.runs) {
        std::size_t first = 0;
        for (std::size_t i = 0; i < run.speed_m_per_s.size(); ++i) {
            if (run.speed_m_per_s[i] <= kMovementSpeed_m_per_s) {
                first = i + 1;
            } else if (microseconds(run.t_s[i + 1]) - microseconds(run.t_s[first]) >=
                       microseconds(kMovementDuration_s)) {
                return run.t_s[first];
            }
        }
    }
    return std::nullopt;
}

std::optional<double> contactStart(const ToolTrace& tool) {
    for (std::size_t i = 0; i < tool.t_s.size(); ++i)
        if (!tool.paused[i] && tool.tissue_N[i].norm() > kContactForce_N)
            return tool.t_s[i];
    return std::nullopt;
}

} // namespace

Motion motionOf(const ToolTrace& tool, double cutOff_Hz) {
    Motion motion;
    const Microseconds step = medianStep(tool);
    const bool slow = step >= kSlowStep;
    motion.dt_s = seconds(slow ? step : kDecimated);
    for (Samples& raw : unpausedRuns(tool, step)) {
        if (!slow) {
            Samples even = onEvenGrid(raw, step);
            even.p = lowPassZeroPhase(even.p, 1.0 / seconds(step), cutOff_Hz);
            raw = onEvenGrid(even, kDecimated);
        }
        motion.runs.push_back(withSpeed(std::move(raw)));
        for (const double v : motion.runs.back().speed_m_per_s)
            motion.peakSpeed_m_per_s = std::max(motion.peakSpeed_m_per_s, v);
    }
    return motion;
}

std::vector<std::span<const double>> subMovements(const PreparedTrial& trial, const Motion& motion) {
    std::vector<std::span<const double>> found;
    if (!trial.movementStart_s)
        return found;
    const double threshold = kSubMovementShare * motion.peakSpeed_m_per_s;
    const auto shortest = static_cast<std::size_t>(
        std::ceil(kSubMovementDuration_s / motion.dt_s - 1e-9)); // whole steps; the margin protects against
                                                                 // rounding
    for (const MotionRun& run : motion.runs) {
        const std::span<const double> speed(run.speed_m_per_s);
        std::size_t first = 0;
        for (std::size_t i = 0; i <= speed.size(); ++i) {
            if (i < speed.size() && speed[i] > threshold)
                continue;
            if (i - first >= std::max<std::size_t>(shortest, 1))
                found.push_back(speed.subspan(first, i - first));
            first = i + 1;
        }
    }
    return found;
}

PreparedTrial prepareTrial(const TrialTrace& trial, double forceLimit_N) {
    PreparedTrial prepared;
    prepared.trial = &trial;
    prepared.forceLimit_N = forceLimit_N;
    if (trial.tools.empty() || trial.tools.front().t_s.empty())
        return prepared;
    prepared.tool = &trial.tools.front();
    prepared.motion = motionOf(*prepared.tool, kMotionCutOff_Hz);
    prepared.jerkMotion = motionOf(*prepared.tool, kJerkCutOff_Hz);
    prepared.movementStart_s = movementStart(prepared.motion);
    prepared.contactStart_s = contactStart(*prepared.tool);
    return prepared;
}

} // namespace chiron::scoring
