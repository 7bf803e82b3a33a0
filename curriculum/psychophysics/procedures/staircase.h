// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/trial_log.h"

namespace chiron::psychophysics {

/// Returns the proportion correct at which an up–down rule converges: where a sequence of `down` right
/// answers precedes one of `up` wrong answers just often enough for the steps to balance (Levitt 1971, Table
/// 1; García-Pérez 1998 for steps down that are `stepRatio` times the steps up: p = (1/(1+r))^(1/down)).
double staircaseTarget(int up, int down, double stepRatio = 1.0) noexcept;

/// Transformed and weighted up–down staircase. Each level follows from the planned one, not from the one that
/// a device made of it; reversals and the estimate use the presented levels.
class Staircase final : public LoggedProcedure {
public:
    static core::Result<std::unique_ptr<Procedure>> make(const StaircaseSpec& spec);
    explicit Staircase(StaircaseSpec spec);

    std::string_view id() const noexcept override { return "staircase@1"; }
    Choice next() const override;
    bool done() const noexcept override { return stopped(m_spec.stop, trials(), reversals()); }
    int reversals() const noexcept override { return static_cast<int>(m_reversalValues.size()); }
    ProcedureEstimate estimate() const override;

    const std::vector<double>& reversalValues() const noexcept { return m_reversalValues; }
    const std::vector<int>& reversalTrials() const noexcept { return m_reversalTrials; } ///< counted from 0

protected:
    void restart() override;
    core::Result<void> take(const RecordedTrial& trial) override;

private:
    enum class Direction { none, up, down };
    Direction stepFor(int outcome);
    void step(Direction direction, int reversalsForSize);
    double clamped(double level) const noexcept;

    StaircaseSpec m_spec;
    double m_level = 0.0;
    int m_right = 0; ///< consecutive
    int m_wrong = 0;
    int m_taken = 0;
    Direction m_direction = Direction::none;
    std::vector<double> m_reversalValues;
    std::vector<int> m_reversalTrials;
};

} // namespace chiron::psychophysics
