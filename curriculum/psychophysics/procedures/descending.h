// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/trial_log.h"

namespace chiron::psychophysics {

/// P2's rule: the difference shrinks level by level until too few of a level's presentations are right. The
/// last level that was passed is taken as the threshold. Legacy: it overestimates the 75 % JND by 0.17-0.51
/// log10 units (x1.5-x3.2), for any participant.
class Descending final : public LoggedProcedure {
public:
    static core::Result<std::unique_ptr<Procedure>> make(const DescendingSpec& spec);
    explicit Descending(DescendingSpec spec);

    std::string_view id() const noexcept override { return "descending_legacy@1"; }
    Choice next() const override;
    bool done() const noexcept override { return m_ended; }
    ProcedureEstimate estimate() const override;

protected:
    void restart() override;
    core::Result<void> take(const RecordedTrial& trial) override;

private:
    DescendingSpec m_spec;
    std::size_t m_row = 0; ///< of the level now presented
    int m_trialsHere = 0;
    int m_rightHere = 0;
    int m_passed = -1; ///< row of the last level passed
    bool m_ended = false;
};

} // namespace chiron::psychophysics
