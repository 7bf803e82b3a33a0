// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/pest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

core::Result<std::unique_ptr<Procedure>> Pest::make(const PestSpec& spec) {
    const auto bad = [](const char* what) { return fail(ErrorCode::badInput, what); };
    if (!std::isfinite(spec.start) || spec.start < spec.minimum || spec.start > spec.maximum)
        return bad("start: expected a number from minimum to maximum");
    if (!(spec.target > 0.0 && spec.target < 1.0))
        return bad("target: expected a proportion between 0 and 1");
    if (!(spec.waldDeviation > 0.0) || !std::isfinite(spec.waldDeviation))
        return bad("wald_deviation: expected a positive number");
    if (!(spec.smallestStep > 0.0 && spec.smallestStep <= spec.step && spec.step <= spec.largestStep &&
          std::isfinite(spec.largestStep)))
        return bad("smallest_step, step, largest_step: expected positive numbers, ascending");
    return std::make_unique<Pest>(spec);
}

Pest::Pest(const PestSpec& spec) : m_spec(spec) {
    restart();
}

void Pest::restart() {
    m_level = m_spec.start;
    m_step = m_spec.step;
    m_trialsHere = m_rightHere = m_direction = m_stepsThisWay = m_reversals = 0;
    m_lastDoubled = m_doubledBeforeReversal = m_ended = false;
}

Choice Pest::next() const {
    Choice choice;
    choice.stimulus = {m_level};
    return choice;
}

core::Result<void> Pest::take(const RecordedTrial& trial) {
    ++m_trialsHere;
    m_rightHere += trial.outcome;
    const double excess = m_rightHere - m_trialsHere * m_spec.target;
    // Allows for rounding, so that a deviation that is just reached is not exceeded.
    const double rounding =
        8.0 * std::numeric_limits<double>::epsilon() * (m_spec.waldDeviation + m_trialsHere);
    if (excess > m_spec.waldDeviation + rounding)
        step(-1);
    else if (excess < -m_spec.waldDeviation - rounding)
        step(1);
    return {};
}

void Pest::step(int direction) {
    if (m_direction != 0 && direction != m_direction) {
        m_doubledBeforeReversal = m_lastDoubled;
        ++m_reversals;
        m_step /= 2.0;
        m_stepsThisWay = 1;
        m_lastDoubled = false;
    } else {
        ++m_stepsThisWay;
        m_lastDoubled = m_stepsThisWay > 3 || (m_stepsThisWay == 3 && !m_doubledBeforeReversal);
        if (m_lastDoubled)
            m_step = std::min(2.0 * m_step, m_spec.largestStep);
    }
    m_ended = m_step <= m_spec.smallestStep; // also for the first step, if it is that small
    m_direction = direction;
    m_level = std::clamp(m_level + direction * m_step, m_spec.minimum, m_spec.maximum);
    m_trialsHere = m_rightHere = 0;
}

ProcedureEstimate Pest::estimate() const {
    ProcedureEstimate estimate;
    estimate.method = m_ended ? "level of the last step (PEST)" : "level reached so far (PEST)";
    estimate.known = m_reversals > 0 || m_ended;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    if (estimate.known)
        estimate.parameters = {{"threshold", m_level, 0.0, nan, nan}};
    return estimate;
}

} // namespace chiron::psychophysics
