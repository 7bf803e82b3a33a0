// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/trace.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace chiron::scoring {

/// Reads the named values of a trial's truth (TrialTrace::truth), from which an exercise fills its own struct
/// (TubeTruth, HandlingTruth, PalpationTruth). A value that is not finite counts as not recorded, like an
/// empty field of a trace file. Remembers the first field that is missing or impossible.
class TruthReader {
public:
    explicit TruthReader(std::span<const NamedValue> truth) : m_truth(truth) {}

    /// None if it is not recorded, which is no fault.
    std::optional<double> optional(std::string_view id) const;
    /// The same for a whole number (rounded); beyond its range, which is a fault, none as well.
    std::optional<int> optionalCount(std::string_view id, int least, int most);
    /// 0 if it is missing, which is a fault.
    double number(std::string_view id);
    /// The same; less than `least` is a fault.
    double atLeast(double least, std::string_view id);
    /// A whole number (rounded); `least` if it is missing or beyond its range, which is a fault. A trace file
    /// may contain any number, so the value is checked before it is converted.
    int count(std::string_view id, int least, int most);

    /// Errors: badInput naming the first field with a fault, what was found and what was expected.
    core::Result<void> done() const;

private:
    void fault(std::string_view id, std::optional<double> found, const std::string& expected);

    std::span<const NamedValue> m_truth;
    std::optional<core::Error> m_fault;
};

/// Adds a value to those of a trial's truth, if there is one.
void addRecorded(std::vector<NamedValue>& truth, std::string_view id, std::optional<double> value);

} // namespace chiron::scoring
