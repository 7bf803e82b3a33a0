// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/elastic_tube/scene/tension_bar.h"
#include "app/exercises/elastic_tube/scene/tube_curve.h"
#include "desktop/scene3d/abdomen/abdomen.h"
#include "desktop/scene3d/abdomen/target_marks.h"
#include "desktop/scene3d/plugin/scene_content.h"

namespace chiron::scene3d {

/// The tube in the abdomen. It is rebuilt from the cues for every picture (about 1,500 vertices).
class TubeContent final : public ISceneContent {
public:
    TubeContent(const SceneSetup& setup, SharedLight& light, Qt3DCore::QEntity* parent);

    void change(const SceneSetup& setup) override;
    void show(const SceneState& state) override;
    void warm() override {}
    double groundHeight_m(double, double) const override { return 0.0; }
    ContentFrame frame() const override;
    ForceBars bars(const SceneSetup& setup, const SceneState& state) const override {
        return {forceDial(setup), tensionBar(m_parameters, state.exercise.of<core::LaparoscopyCues>())};
    }
    void putOn(const SceneLayers& layers) override;

private:
    static constexpr double kFieldRadius_m = 0.052;

    void showTarget(const core::LaparoscopyCues& cues);

    simulation::ElasticTubeParameters m_parameters;
    Abdomen* m_abdomen;
    Part* m_tube;
    Part* m_marks;
    Part* m_fold;
    Part* m_shade;
    Qt3DRender::QParameter* m_ink;
    TargetRing* m_target;
};

} // namespace chiron::scene3d
