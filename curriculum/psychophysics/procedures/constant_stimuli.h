// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "psychophysics/procedures/procedure.h"
#include "psychophysics/procedures/procedure_spec.h"
#include "psychophysics/procedures/trial_log.h"

namespace chiron::psychophysics {

/// Constant stimuli, also used for the fixed schedules of adjustment and magnitude estimation. Every level is
/// presented the same number of times, in shuffled blocks that contain each level once. A spoiled trial is
/// repeated at a random later position. Outcome 1 means right or yes; for adjustment and magnitude it is
/// always 1.
class ConstantStimuli final : public Procedure {
public:
    static core::Result<std::unique_ptr<Procedure>> make(const ConstantSpec& spec, std::uint64_t seed);
    ConstantStimuli(const ConstantSpec& spec, std::uint64_t seed);

    std::string_view id() const noexcept override { return "constant@1"; }
    Choice next() const override;
    core::Result<void> record(int outcome, const Stimulus& presented) override;
    core::Result<void> undo() override;
    void spoiled() override;
    bool done() const noexcept override { return m_log.size() >= m_queue.size(); }
    int trials() const noexcept override { return static_cast<int>(m_log.size()); }
    /// Returns where the proportions, made monotone by pooling, cross 75, 50 (PSE) and 25 %; JND = (x75 -
    /// x25)/2. Proper fits are in psychophysics/fits.
    ProcedureEstimate estimate() const override;

private:
    std::vector<double> m_levels;
    /// Rows of m_levels in the order of presentation; the first m_log.size() are done.
    std::vector<int> m_queue;
    std::vector<RecordedTrial> m_log;
    core::Random m_random; ///< for the positions to which spoiled trials move
};

} // namespace chiron::psychophysics
