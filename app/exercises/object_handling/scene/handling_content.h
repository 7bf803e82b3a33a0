// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/object_handling/scene/organ_bed.h"
#include "app/exercises/object_handling/scene/squeeze_bar.h"
#include "desktop/scene3d/abdomen/abdomen.h"
#include "desktop/scene3d/abdomen/target_marks.h"
#include "desktop/scene3d/plugin/scene_content.h"

#include <array>

namespace chiron::scene3d {

/// Ovaries in the abdomen that are lifted, weighed and set down in a dish (on a soft organ: in a ring).
class HandlingContent final : public ISceneContent {
public:
    HandlingContent(const SceneSetup& setup, SharedLight& light, Qt3DCore::QEntity* parent);

    void change(const SceneSetup& setup) override;
    void show(const SceneState& state) override;
    void warm() override {}
    double groundHeight_m(double x_m, double y_m) const override {
        return organHeight_m(m_parameters, x_m, y_m);
    }
    ContentFrame frame() const override;
    ForceBars bars(const SceneSetup& setup, const SceneState& state) const override {
        return {forceDial(setup), squeezeBar(m_parameters, state.exercise.of<core::LaparoscopyCues>())};
    }
    void putOn(const SceneLayers& layers) override;

private:
    static constexpr double kFieldRadius_m = 0.056;

    void showBodies(const SceneState& state);
    void showDish(const core::LaparoscopyCues& cues);
    void showOrgan(const SceneState& state);

    simulation::ObjectHandlingParameters m_parameters;
    Abdomen* m_abdomen;
    std::array<Part*, core::LaparoscopyCues::kMaxBodies> m_body{};
    Part* m_shade;
    Part* m_dish;
    double m_dishRadius_m = 0.0;
    TargetRing* m_target;
    Part* m_organ = nullptr; ///< the soft bed; null if the objects lie on the floor
    TriangleMesh m_organAtRest;
    bool m_organDented = false;
};

} // namespace chiron::scene3d
