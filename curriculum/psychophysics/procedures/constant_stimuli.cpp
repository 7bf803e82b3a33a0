// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/constant_stimuli.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostTrials = 1'000'000;

struct Point {
    double x = 0.0;
    double proportion = 0.0;
    double weight = 0.0;
};

/// Returns the proportions right by presented level, made non-decreasing by pooling neighbours that fall
/// (pool adjacent violators).
std::vector<Point> risingProportions(const std::vector<RecordedTrial>& log) {
    std::map<double, std::pair<int, int>> counts;
    for (const RecordedTrial& trial : log) {
        auto& [right, all] = counts[trial.presented[0]];
        right += trial.outcome;
        ++all;
    }
    std::vector<Point> points;
    std::vector<Point> pools; // x: number of points in the pool
    for (const auto& [x, count] : counts) {
        points.push_back({x, 0.0, 0.0});
        pools.push_back(
            {1.0, static_cast<double>(count.first) / count.second, static_cast<double>(count.second)});
        while (pools.size() > 1 && pools[pools.size() - 2].proportion > pools.back().proportion) {
            const Point last = pools.back();
            pools.pop_back();
            Point& before = pools.back();
            before.proportion = (before.proportion * before.weight + last.proportion * last.weight) /
                                (before.weight + last.weight);
            before.weight += last.weight;
            before.x += last.x;
        }
    }
    std::size_t next = 0;
    for (const Point& pool : pools)
        for (int i = 0; i < static_cast<int>(pool.x); ++i)
            points[next++].proportion = pool.proportion;
    return points;
}

/// Returns where rising points cross a proportion, interpolated between the two neighbours. If a stretch lies
/// exactly on the proportion, the result is its middle, so that mirrored data give the mirrored result. Not a
/// number if there is no crossing.
double crossing(const std::vector<Point>& points, double proportion) {
    const auto between = [&](std::size_t i) {
        return points[i - 1].x + (points[i].x - points[i - 1].x) * (proportion - points[i - 1].proportion) /
                                     (points[i].proportion - points[i - 1].proportion);
    };
    double reached = kNan, left = kNan;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i - 1].proportion < proportion && points[i].proportion >= proportion)
            reached = between(i);
        if (points[i - 1].proportion <= proportion && points[i].proportion > proportion)
            left = between(i);
    }
    if (std::isnan(reached) || std::isnan(left))
        return std::isnan(reached) ? left : reached;
    return 0.5 * (reached + left);
}

} // namespace

core::Result<std::unique_ptr<Procedure>> ConstantStimuli::make(const ConstantSpec& spec, std::uint64_t seed) {
    if (spec.levels.empty() ||
        !std::all_of(spec.levels.begin(), spec.levels.end(), [](double x) { return std::isfinite(x); }))
        return fail(ErrorCode::badInput, "levels: expected finite numbers, at least one");
    if (spec.repeats < 1 || static_cast<std::size_t>(spec.repeats) > kMostTrials / spec.levels.size())
        return fail(ErrorCode::badInput, "repeats: expected at least 1, and at most a million trials in all");
    return std::make_unique<ConstantStimuli>(spec, seed);
}

ConstantStimuli::ConstantStimuli(const ConstantSpec& spec, std::uint64_t seed)
    : m_levels(spec.levels), m_random(core::Random::stream(seed, "constant.spoiled")) {
    core::Random order = core::Random::stream(seed, "constant.order");
    for (int block = 0; block < spec.repeats; ++block) {
        const std::size_t first = m_queue.size();
        for (std::size_t row = 0; row < m_levels.size(); ++row)
            m_queue.push_back(static_cast<int>(row));
        for (std::size_t i = m_levels.size(); spec.shuffled && i > 1; --i)
            std::swap(m_queue[first + i - 1], m_queue[first + order.below(i)]);
    }
}

Choice ConstantStimuli::next() const {
    Choice choice;
    choice.candidate = m_queue[std::min(m_log.size(), m_queue.size() - 1)];
    choice.stimulus = {m_levels[static_cast<std::size_t>(choice.candidate)]};
    return choice;
}

core::Result<void> ConstantStimuli::record(int outcome, const Stimulus& presented) {
    if (done())
        return fail(ErrorCode::badInput, "outcome after the last trial: expected none");
    if (outcome < 0 || outcome > 1)
        return fail(ErrorCode::badInput, "outcome " + std::to_string(outcome) + ": expected 0 or 1");
    if (presented.size() != 1 || !std::isfinite(presented[0]))
        return fail(ErrorCode::badInput, "stimulus: expected one finite number");
    m_log.push_back({outcome, presented});
    return {};
}

core::Result<void> ConstantStimuli::undo() {
    if (m_log.empty())
        return fail(ErrorCode::wrongUse, "there is no recorded outcome to take back");
    m_log.pop_back();
    return {};
}

void ConstantStimuli::spoiled() {
    const std::size_t now = m_log.size();
    if (now + 1 >= m_queue.size())
        return; // the last trial: repeated at once
    const std::size_t later = now + 1 + m_random.below(m_queue.size() - now - 1);
    const auto begin = m_queue.begin();
    std::rotate(begin + static_cast<std::ptrdiff_t>(now), begin + static_cast<std::ptrdiff_t>(now) + 1,
                begin + static_cast<std::ptrdiff_t>(later) + 1);
}

ProcedureEstimate ConstantStimuli::estimate() const {
    ProcedureEstimate estimate;
    estimate.method = "proportions, made to rise, between levels";
    const std::vector<Point> points = risingProportions(m_log);
    const double x75 = crossing(points, 0.75);
    const double x50 = crossing(points, 0.5);
    const double x25 = crossing(points, 0.25);
    estimate.known = !std::isnan(x75) || !std::isnan(x50);
    if (estimate.known)
        estimate.parameters = {{"threshold", x75, 0.0, kNan, kNan},
                               {"pse", x50, 0.0, kNan, kNan},
                               {"jnd", 0.5 * (x75 - x25), 0.0, kNan, kNan}};
    return estimate;
}

} // namespace chiron::psychophysics
