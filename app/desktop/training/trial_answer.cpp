// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/trial_answer.h"

#include "cues/laparoscopy_cues.h"

#include <cmath>

namespace chiron::desktop {

QString markTaken() {
    return AnswerTexts::tr("Marked");
}

QString MarkAnswer::markWords(const session::TrialObject&, const session::LiveSample&, const QLocale&) const {
    return markTaken();
}

bool MarkAnswer::keep(const session::TrialObject& truth, const std::optional<core::Vec3>& p_WMark) {
    if (truth.radius_m <= 0.0)
        return false;
    m_truth = truth;
    m_p_WMark = p_WMark;
    return true;
}

void MarkAnswer::show(scene3d::SceneState& drawn) const {
    drawn.objectShown = true;
    drawn.p_WObject = m_truth.p_WObject;
    drawn.exercise.own<core::LaparoscopyCues>().body[0].q_W = {std::cos(0.5 * m_truth.turn_rad), 0.0, 0.0,
                                                               std::sin(0.5 * m_truth.turn_rad)};
    drawn.answered = true;
    drawn.p_WAnswer = m_truth.p_WObject + m_truth.radius_m * core::Vec3::UnitZ();
    drawn.marked = m_p_WMark.has_value();
    drawn.p_WMark = m_p_WMark.value_or(core::Vec3::Zero());
}

} // namespace chiron::desktop
