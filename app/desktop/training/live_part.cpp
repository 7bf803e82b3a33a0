// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/live_part.h"

#include "desktop/training/endoscope_control.h"
#include "desktop/training/info_panel.h"
#include "desktop/training/pointer_control.h"
#include "session/level_limits.h"

namespace chiron::desktop {

std::unique_ptr<HandControl> LivePart::takeHand(session::LiveTraining& training,
                                                std::function<void(int)>) const {
    const double scale = m_around.theme.scale();
    if (training.pointer())
        return std::make_unique<PointerControl>(*training.pointer(), scale, m_around.leftHanded);
    if (training.endoscope())
        return std::make_unique<EndoscopeControl>(*training.endoscope(), scale, m_around.leftHanded);
    return nullptr;
}

PointPart::PointPart(const catalogue::ExerciseLevel& level, LiveSurroundings around)
    : LivePart(std::move(around)), m_limit_N(session::levelLimits(level).force_N) {}

InfoView* PointPart::makePanel() {
    return new InfoPanel(around().theme, around().locale, around().cues, {.force_N = m_limit_N});
}

} // namespace chiron::desktop
