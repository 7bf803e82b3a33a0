// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/undefined_reason.h"

namespace chiron::scoring {

// clang-format off
namespace reasons {
inline constexpr UndefinedReason kNoSqueeze{"the trace has no squeeze", QT_TRANSLATE_NOOP("Metrics", "the recording has no squeeze")};
inline constexpr UndefinedReason kNoSqueezeLimit{"the trace has no squeeze limit", QT_TRANSLATE_NOOP("Metrics", "the recording has no squeeze limit")};
inline constexpr UndefinedReason kNoObjectsAndTarget{"the trace has no objects and target", QT_TRANSLATE_NOOP("Metrics", "the recording has neither objects nor a target")};
inline constexpr UndefinedReason kNoWeighing{"no weighing was asked for", QT_TRANSLATE_NOOP("Metrics", "the level asks for no weighing")};
} // namespace reasons
// clang-format on

inline constexpr std::array kHandlingReasons{reasons::kNoSqueeze, reasons::kNoSqueezeLimit,
                                             reasons::kNoObjectsAndTarget, reasons::kNoWeighing};

} // namespace chiron::scoring
