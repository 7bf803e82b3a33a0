// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/trial_log.h"

namespace chiron::psychophysics {

/// Parameter estimation by sequential testing (Taylor & Creelman 1967), for replication. At one level n trials with k right: when
/// |k - n·target| exceeds the Wald deviation, a step. Steps halve at every reversal; the second in a direction is like the first; the fourth and
/// later double; the third doubles unless the step just before the last reversal came of doubling. A step that would be no more than
/// the smallest is taken and ends the run: the estimate is the level it leads to. (pest@1 ended at reversals only, and took a deviation
/// that was just reached for one exceeded where rounding had it so.)
class Pest final : public LoggedProcedure {
public:
    static core::Result<std::unique_ptr<Procedure>> make(const PestSpec& spec);
    explicit Pest(const PestSpec& spec);

    std::string_view id() const noexcept override { return "pest@2"; }
    Choice next() const override;
    bool done() const noexcept override { return m_ended || stopped(m_spec.stop, trials(), m_reversals); }
    int reversals() const noexcept override { return m_reversals; }
    ProcedureEstimate estimate() const override;

protected:
    void restart() override;
    core::Result<void> take(const RecordedTrial& trial) override;

private:
    void step(int direction);

    PestSpec m_spec;
    double m_level = 0.0;
    double m_step = 0.0;
    int m_trialsHere = 0;
    int m_rightHere = 0;
    int m_direction = 0; ///< of the last step: -1 down, 1 up
    int m_stepsThisWay = 0;
    bool m_lastDoubled = false;           ///< the last step came of doubling
    bool m_doubledBeforeReversal = false; ///< the step just before the last reversal did
    int m_reversals = 0;
    bool m_ended = false;
};

} // namespace chiron::psychophysics
