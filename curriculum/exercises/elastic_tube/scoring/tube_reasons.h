// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/undefined_reason.h"

namespace chiron::scoring {

// clang-format off
namespace reasons {
inline constexpr UndefinedReason kNoTubeData{"the trace has no data of a tube", QT_TRANSLATE_NOOP("Metrics", "the recording has no tube data")};
inline constexpr UndefinedReason kTensionNeverHeld{"the tension was never held", QT_TRANSLATE_NOOP("Metrics", "the tension was never held")};
} // namespace reasons
// clang-format on

inline constexpr std::array kTubeReasons{reasons::kNoTubeData, reasons::kTensionNeverHeld};

} // namespace chiron::scoring
