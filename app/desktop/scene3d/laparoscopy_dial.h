// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/gauge_painter.h"

#include <optional>

namespace chiron::scene3d {

/// The second bar of an exercise that grasps: tension of the tube with its band, or squeeze of the jaws with its limit. What
/// it shows follows from the level (its scale) and the cues (band, limit). Empty: this exercise has none. Pure.
std::optional<GaugeDial> laparoscopyDial(const SceneSetup& setup, const core::LaparoscopyCues& cues);

/// Whether the level lets it be seen now, and its value, N.
bool dialShown(const core::LaparoscopyCues& cues);
double dialValue_N(const core::LaparoscopyCues& cues);

} // namespace chiron::scene3d
