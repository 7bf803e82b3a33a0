// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/grasp_note.h"
#include "desktop/training/live_part.h"

namespace chiron::desktop {

/// The part of the training screen for levels with graspers: their panel, hand control and messages about
/// failed grasps.
class GraspPart final : public LivePart {
public:
    /// `feedback`: the level explains failed grasps; a practice does so, too.
    GraspPart(Grasping grasping, bool feedback, LiveSurroundings around);

    InfoView* makePanel() override;
    std::unique_ptr<HandControl> takeHand(session::LiveTraining& training,
                                          std::function<void(int)> chosen) const override;
    QString activeText(int tool) const override;
    void show(const haptics::DisplayState& state, std::span<const session::LiveSample> samples,
              scene3d::SceneState& drawn) override;
    scene3d::SceneNote note(std::int64_t now_ns) const override { return m_note.note(now_ns); }

private:
    Grasping m_grasping;
    GraspNote m_note;
};

} // namespace chiron::desktop
