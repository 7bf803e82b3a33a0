// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/grasp_part.h"

#include "desktop/training/grasp_panel.h"
#include "desktop/training/grasper_control.h"
#include "desktop/training/training_words.h"

namespace chiron::desktop {

GraspPart::GraspPart(Grasping grasping, bool feedback, LiveSurroundings around)
    : LivePart(std::move(around)), m_grasping(std::move(grasping)),
      m_note(m_grasping, this->around().locale, feedback || this->around().practises) {}

InfoView* GraspPart::makePanel() {
    return new GraspPanel(around().theme, around().locale, around().cues, m_grasping);
}

std::unique_ptr<HandControl> GraspPart::takeHand(session::LiveTraining& training,
                                                 std::function<void(int)> chosen) const {
    const std::vector<devices::PointerMailbox*> mailboxes = training.pointers();
    if (mailboxes.empty())
        return nullptr; // the person does not move the tool
    auto graspers = std::make_unique<GrasperControl>(mailboxes, around().theme.scale(), around().leftHanded);
    graspers->onChosen(std::move(chosen));
    return graspers;
}

QString GraspPart::activeText(int tool) const {
    return m_grasping.tools > 1 ? activeToolInWords(tool, m_grasping.tools) : QString();
}

void GraspPart::show(const haptics::DisplayState& state, std::span<const session::LiveSample>,
                     scene3d::SceneState&) {
    m_note.take(state);
}

} // namespace chiron::desktop
