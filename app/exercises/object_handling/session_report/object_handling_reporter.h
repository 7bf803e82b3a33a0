// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session_report/exercise_reporter.h"

namespace chiron::session_report {

class ObjectHandlingReporter final : public ExerciseReporter {
public:
    std::string_view id() const noexcept override { return "object_handling"; }
    std::shared_ptr<const report::ReportSection>
    section(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level) const override;
    EndWords ends() const override;
    std::span<const StageWords> stages() const noexcept override;
};

} // namespace chiron::session_report
