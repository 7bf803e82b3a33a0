// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session_report/exercise_reporter.h"

namespace chiron::session_report {

/// The task of studies has no section of its own: its studies have reports of their own.
class ComparisonReporter final : public ExerciseReporter {
public:
    std::string_view id() const noexcept override { return "comparison"; }
    EndWords ends() const override;
    std::span<const MarkWords> marks() const noexcept override;
};

} // namespace chiron::session_report
