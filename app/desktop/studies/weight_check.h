// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/freeze_checks.h"

#include <QLocale>
#include <optional>

namespace chiron::desktop {

/// Advises where merely holding the heaviest object takes nearly the largest force of a trial
/// (session::FidelityMeter::kNearForceLimit): what participants are told then would give this object away.
/// Returns nothing if no object is so heavy.
std::optional<FreezeCheck> weightCheck(const psychophysics::StudyDesign& design, const QLocale& locale);

} // namespace chiron::desktop
