// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/procedure.h"
#include "psychophysics/procedures/procedure_spec.h"

#include <optional>
#include <utility>
#include <vector>

namespace chiron::psychophysics {

/// A trial as it was recorded.
struct RecordedTrial {
    int outcome = 0;
    Stimulus presented;
};

/// What nearly all procedures do alike: they keep their trials, and take one back by starting afresh and hearing all others again, so that
/// after undo() every double is what it would have been had the trial never happened.
class LoggedProcedure : public Procedure {
public:
    core::Result<void> record(int outcome, const Stimulus& presented) final;
    core::Result<void> undo() final;
    void spoiled() override {}
    int trials() const noexcept final { return static_cast<int>(m_log.size()); }
    const std::vector<RecordedTrial>& log() const noexcept { return m_log; }

protected:
    virtual std::size_t dimensions() const noexcept { return 1; }
    virtual void restart() = 0;
    /// Takes one trial in, already checked. Failure: nothing was changed.
    virtual core::Result<void> take(const RecordedTrial& trial) = 0;

private:
    std::vector<RecordedTrial> m_log;
};

/// Whether a run of so many trials and reversals is over. `sd`: of the first parameter, where there is one.
bool stopped(const StopRule& rule, int trials, int reversals, std::optional<double> sd = std::nullopt) noexcept;

} // namespace chiron::psychophysics
