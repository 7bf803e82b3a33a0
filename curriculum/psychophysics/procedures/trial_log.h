// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/procedure.h"
#include "psychophysics/procedures/procedure_spec.h"

#include <optional>
#include <utility>
#include <vector>

namespace chiron::psychophysics {

/// One recorded trial.
struct RecordedTrial {
    int outcome = 0;
    Stimulus presented;
};

/// Base of nearly all procedures. It keeps the trials and takes one back by restarting and replaying all
/// others, so that after undo() every double is what it would have been without that trial.
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
    /// Processes one trial that has been checked already. If it fails, nothing was changed.
    virtual core::Result<void> take(const RecordedTrial& trial) = 0;

private:
    std::vector<RecordedTrial> m_log;
};

/// Returns whether a run with this many trials and reversals is over. `sd` is that of the first parameter, if
/// there is one.
bool stopped(const StopRule& rule, int trials, int reversals,
             std::optional<double> sd = std::nullopt) noexcept;

} // namespace chiron::psychophysics
