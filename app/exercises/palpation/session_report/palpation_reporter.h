// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session_report/exercise_reporter.h"

namespace chiron::session_report {

class PalpationReporter final : public ExerciseReporter {
public:
    std::string_view id() const noexcept override { return "palpation"; }
    std::shared_ptr<const report::ReportSection>
    section(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level) const override;
    EndWords ends() const override;
    std::span<const MarkWords> marks() const noexcept override;
    QString toolName(const catalogue::ExerciseLevel& level, int tool, int tools) const override; ///< a finger
};

} // namespace chiron::session_report
