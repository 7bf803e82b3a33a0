// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/trial_log.h"

namespace chiron::psychophysics {

/// Parameter estimation by sequential testing (Taylor & Creelman 1967), for replication. After n trials at
/// one level with k right, a step follows when |k - n·target| exceeds the Wald deviation. Steps halve at
/// every reversal. The second step in a direction has the same size as the first; the fourth and later ones
/// double; the third doubles unless the step just before the last reversal resulted from doubling. A step
/// that is not larger than the smallest is still taken and ends the run: the estimate is the level to which
/// it leads. (pest@1 ended only at reversals, and through rounding could treat a deviation that was just
/// reached as exceeded.)
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
    bool m_lastDoubled = false;           ///< the last step resulted from doubling
    bool m_doubledBeforeReversal = false; ///< the step just before the last reversal did
    int m_reversals = 0;
    bool m_ended = false;
};

} // namespace chiron::psychophysics
