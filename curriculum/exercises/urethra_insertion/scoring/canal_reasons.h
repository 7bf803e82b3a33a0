// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/undefined_reason.h"

namespace chiron::scoring {

// clang-format off
namespace reasons {
inline constexpr UndefinedReason kNoInsertionData{"the trace has no insertion data", QT_TRANSLATE_NOOP("Metrics", "the recording has no insertion data")};
inline constexpr UndefinedReason kNeverInUrethra{"the tip was never in the urethra", QT_TRANSLATE_NOOP("Metrics", "the tip was never in the urethra")};
inline constexpr UndefinedReason kNeverAtBend{"the tip was never at the bend", QT_TRANSLATE_NOOP("Metrics", "the tip was never at the bend")};
inline constexpr UndefinedReason kNoLandmarks{"the level has no landmarks", QT_TRANSLATE_NOOP("Metrics", "the level has no landmarks")};
inline constexpr UndefinedReason kInspectionNotReached{"the inspection was not reached", QT_TRANSLATE_NOOP("Metrics", "the inspection was not reached")};
} // namespace reasons
// clang-format on

inline constexpr std::array kCanalReasons{reasons::kNoInsertionData, reasons::kNeverInUrethra,
                                          reasons::kNeverAtBend, reasons::kNoLandmarks,
                                          reasons::kInspectionNotReached};

} // namespace chiron::scoring
