// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/staircase.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

namespace {

constexpr double kLeastRatio = 1e-300; ///< of a level on a log or dB axis
/// For start and steps: from smaller values no run reaches infinity.
constexpr double kLargest = 1e100;

double sizeAt(const std::vector<double>& sizes, int reversals) {
    return sizes[std::min(static_cast<std::size_t>(reversals), sizes.size() - 1)];
}

bool allPositive(const std::vector<double>& sizes) {
    return std::all_of(sizes.begin(), sizes.end(), [](double s) { return s > 0.0 && s <= kLargest; });
}

core::Result<void> checkStaircase(const StaircaseSpec& spec) {
    const auto bad = [](const char* what) { return fail(ErrorCode::badInput, what); };
    if (!(std::abs(spec.start) <= kLargest))
        return bad("start: expected a number within 1e100 of 0");
    if (spec.up < 1)
        return bad("up: expected at least 1");
    if (spec.down < 1)
        return bad("down: expected at least 1");
    if (spec.stepsUp.empty() || !allPositive(spec.stepsUp))
        return bad("steps_up: expected positive numbers up to 1e100, at least one");
    if (!allPositive(spec.stepsDown))
        return bad("steps_down: expected positive numbers up to 1e100");
    if (!(spec.stepRatio >= 0.0 && spec.stepRatio <= kLargest))
        return bad("step_ratio: expected 0 or a positive number up to 1e100");
    if (spec.minimum && spec.maximum && *spec.minimum > *spec.maximum)
        return bad("minimum: expected at most the maximum");
    if (spec.truncate &&
        ((spec.minimum && spec.start < *spec.minimum) || (spec.maximum && spec.start > *spec.maximum)))
        return bad("start: expected a number from minimum to maximum, where levels are truncated");
    if (spec.stepType != StaircaseSpec::StepType::linear && spec.start <= 0.0)
        return bad("start: expected a positive number for steps of type log or db");
    if (spec.estimateReversals < 2)
        return bad("estimate_reversals: expected at least 2");
    if (spec.stop.trials <= 0 && spec.stop.reversals <= 0)
        return bad("stop: expected trials or reversals");
    return {};
}

} // namespace

double staircaseTarget(int up, int down, double stepRatio) noexcept {
    const double wanted = 1.0 / (1.0 + stepRatio); // share of the steps that go down
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double p = 0.5 * (low + high);
        const double rights = std::pow(p, down - 1);
        const double wrongs = std::pow(1.0 - p, up - 1);
        const double goesDown = rights * (1.0 - wrongs * (1.0 - p)) / (rights + wrongs - rights * wrongs);
        (goesDown < wanted ? low : high) = p;
    }
    return 0.5 * (low + high);
}

core::Result<std::unique_ptr<Procedure>> Staircase::make(const StaircaseSpec& spec) {
    CHIRON_TRY(checkStaircase(spec));
    return std::make_unique<Staircase>(spec);
}

Staircase::Staircase(StaircaseSpec spec) : m_spec(std::move(spec)) {
    restart();
}

void Staircase::restart() {
    m_level = m_spec.start;
    m_right = m_wrong = m_taken = 0;
    m_direction = Direction::none;
    m_reversalValues.clear();
    m_reversalTrials.clear();
}

double Staircase::clamped(double level) const noexcept {
    if (m_spec.maximum && level > *m_spec.maximum)
        return *m_spec.maximum;
    return m_spec.minimum && level < *m_spec.minimum ? *m_spec.minimum : level;
}

Choice Staircase::next() const {
    Choice choice;
    choice.stimulus = {clamped(m_level)};
    return choice;
}

/// Returns the direction in which an outcome moves the level; counts consecutive answers.
Staircase::Direction Staircase::stepFor(int outcome) {
    m_right = outcome == 1 ? m_right + 1 : 0;
    m_wrong = outcome == 1 ? 0 : m_wrong + 1;
    if (m_spec.initialOneUpOneDown && m_reversalValues.empty())
        return outcome == 1 ? Direction::down : Direction::up;
    if (m_right >= m_spec.down)
        return Direction::down;
    return m_wrong >= m_spec.up ? Direction::up : Direction::none;
}

void Staircase::step(Direction direction, int reversalsForSize) {
    double size = sizeAt(m_spec.stepsUp, reversalsForSize);
    if (direction == Direction::down) {
        if (!m_spec.stepsDown.empty())
            size = sizeAt(m_spec.stepsDown, reversalsForSize);
        if (m_spec.stepRatio > 0.0)
            size = sizeAt(m_spec.stepsUp, reversalsForSize) * m_spec.stepRatio;
    }
    const double sign = direction == Direction::up ? 1.0 : -1.0;
    switch (m_spec.stepType) {
    case StaircaseSpec::StepType::linear:
        m_level += sign * size;
        break;
    case StaircaseSpec::StepType::log:
        m_level *= std::pow(10.0, sign * size);
        break;
    case StaircaseSpec::StepType::db:
        m_level *= std::pow(10.0, sign * size / 20.0);
        break;
    }
    if (m_spec.stepType != StaircaseSpec::StepType::linear)
        // From 0 or infinity no step would lead back.
        m_level = std::clamp(m_level, kLeastRatio, 1.0 / kLeastRatio);
    if (m_spec.truncate)
        m_level = clamped(m_level);
}

core::Result<void> Staircase::take(const RecordedTrial& trial) {
    const int before = reversals();
    const Direction direction = stepFor(trial.outcome);
    if (direction != Direction::none) {
        if (m_direction != Direction::none && m_direction != direction) {
            m_reversalTrials.push_back(m_taken);
            m_reversalValues.push_back(trial.presented[0]);
        }
        m_direction = direction;
        step(direction, m_spec.newStepAtReversal ? reversals() : before);
        if (m_spec.resetCounters)
            m_right = m_wrong = 0;
    }
    ++m_taken;
    return {};
}

ProcedureEstimate Staircase::estimate() const {
    ProcedureEstimate estimate;
    const int used = std::min(m_spec.estimateReversals, reversals()) / 2 * 2;
    estimate.method = "mean of the last " + std::to_string(used) + " reversals";
    if (used < 2)
        return estimate;
    double sum = 0.0;
    for (int i = reversals() - used; i < reversals(); ++i)
        sum += m_reversalValues[static_cast<std::size_t>(i)];
    const double mean = sum / used;
    double squares = 0.0;
    for (int i = reversals() - used; i < reversals(); ++i)
        squares += std::pow(m_reversalValues[static_cast<std::size_t>(i)] - mean, 2);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    estimate.known = true;
    estimate.parameters = {{"threshold", mean, std::sqrt(squares / (used - 1) / used), nan, nan}};
    return estimate;
}

} // namespace chiron::psychophysics
