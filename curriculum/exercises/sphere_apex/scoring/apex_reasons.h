// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/undefined_reason.h"

namespace chiron::scoring {

// clang-format off
namespace reasons {
inline constexpr UndefinedReason kNeedsTwoTrials{"needs two trials or more", QT_TRANSLATE_NOOP("Metrics", "needs two trials or more")};
inline constexpr UndefinedReason kOneTrialHasNoChance{"one trial alone has no chance level", QT_TRANSLATE_NOOP("Metrics", "there is no chance level for a single trial")};
inline constexpr UndefinedReason kApexUnknown{"the apex's true place is not known", QT_TRANSLATE_NOOP("Metrics", "the true position of the apex is not known")};
} // namespace reasons
// clang-format on

inline constexpr std::array kApexReasons{reasons::kNeedsTwoTrials, reasons::kOneTrialHasNoChance,
                                         reasons::kApexUnknown};

} // namespace chiron::scoring
