// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <initializer_list>
#include <string>

namespace chiron::operators {

/// A setting of an operator, or something that it was told, with the values that it may have.
struct SettingRange {
    const char* name;
    double value, low, high;
};

/// Errors: badInput for the first value that is not in its range (NaN is in none), with its name.
inline core::Result<void> checkRanges(std::initializer_list<SettingRange> ranges) {
    for (const SettingRange& range : ranges)
        if (!(range.value >= range.low && range.value <= range.high))
            return core::fail(core::ErrorCode::badInput, std::string("operator: ") + range.name + " is " +
                                                             std::to_string(range.value) + ", expected " +
                                                             std::to_string(range.low) + " to " +
                                                             std::to_string(range.high));
    return {};
}

} // namespace chiron::operators
