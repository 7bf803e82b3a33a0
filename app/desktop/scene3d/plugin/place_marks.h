// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/scene_content.h"

namespace chiron::scene3d {

/// Marks that show positions: a thin line from the tip straight down to whatever lies below it, with a foot
/// at its end; and, in playback and as feedback after a trial, a pin where the person marked and a double
/// ring where the mark should have been.
class PlaceMarks final : public Qt3DCore::QEntity {
public:
    PlaceMarks(SharedLight& light, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup);
    void show(const SceneState& state, const ISceneContent& content);

private:
    SceneSetup m_setup;
    Qt3DRender::QParameter* m_lineTint;
    Qt3DRender::QParameter* m_pinTint;
    Part* m_line[core::kMaxTools];
    Part* m_foot[core::kMaxTools];
    Qt3DCore::QEntity* m_pin;
    Qt3DCore::QTransform* m_pinAt;
    Qt3DCore::QEntity* m_answer;
    Qt3DCore::QTransform* m_answerAt;
};

} // namespace chiron::scene3d
