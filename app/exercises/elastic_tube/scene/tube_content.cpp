// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/scene/tube_content.h"

#include "app/exercises/elastic_tube/scene/fold_sheet.h"
#include "app/exercises/elastic_tube/scene/mark_ring.h"
#include "app/exercises/elastic_tube/scene/tube_mesh.h"

#include <algorithm>

namespace chiron::scene3d {

namespace {
const OrganLook kFold{{0.98F, 0.86F, 0.66F, 0.75F}, {0.93F, 0.70F, 0.50F, 0.85F}}; // peritoneum over fat
const OrganLook kTube{{1.0F, 0.80F, 0.72F, 0.65F}, {0.97F, 0.66F, 0.60F, 0.9F}};
} // namespace

TubeContent::TubeContent(const SceneSetup& setup, SharedLight& light, Qt3DCore::QEntity* parent)
    : m_parameters(setup.parameters.as<simulation::ElasticTubeParameters>()),
      m_abdomen(new Abdomen(light, kFieldRadius_m, parent)) {
    m_tube = new Part({}, m_abdomen->organ(kTube, m_abdomen), m_abdomen);
    m_fold = new Part({}, m_abdomen->organ(kFold, m_abdomen), m_abdomen);
    m_ink =
        new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(0.16F, 0.10F, 0.38F, 1.0F), m_abdomen);
    m_marks =
        new Part({}, light.effects.material("solid.vert", "signal.frag", {m_ink}, Blend::opaque, m_abdomen),
                 m_abdomen);
    m_shade = new Part({}, m_abdomen->shade(m_abdomen), m_abdomen);
    m_target = new TargetRing(light, m_abdomen);
    for (Part* part : {m_tube, m_marks, m_shade, m_fold})
        part->setEnabled(false);
}

ContentFrame TubeContent::frame() const {
    // The tube can reach this high before it tears, plus the jaws on it.
    const double reach_m = m_parameters.restLength_m * m_parameters.tearRatio * 0.9 + 0.010;
    return {.fieldRadius_m = kFieldRadius_m, .roomAbove_m = std::min(0.074, reach_m), .draped = false};
}

void TubeContent::putOn(const SceneLayers& layers) {
    m_shade->addComponent(layers.translucent);
    m_target->putTranslucent(layers.translucent);
}

void TubeContent::change(const SceneSetup& setup) {
    m_parameters = setup.parameters.as<simulation::ElasticTubeParameters>();
    m_abdomen->change(setup);
    m_target->change(setup);
}

void TubeContent::show(const SceneState& state) {
    m_abdomen->show(state);
    const core::LaparoscopyCues& cues = state.exercise.of<core::LaparoscopyCues>();
    const bool shown = cues.present && cues.objectShown && cues.tube;
    for (Part* part : {m_tube, m_marks, m_shade})
        part->setEnabled(shown);
    if (shown) {
        const TubeCurve curve = TubeCurve::of(cues, m_parameters.radius_m);
        m_tube->mesh().setMesh(tubeMesh(curve));
        m_marks->mesh().setMesh(tubeMarks(curve, cues));
        m_shade->mesh().setMesh(tubeShade(curve, 0.0));
    }
    m_fold->setEnabled(shown && cues.fold);
    if (shown && cues.fold) {
        const double most_N = m_parameters.retractionHigh_N;
        m_fold->mesh().setMesh(
            foldMesh(FoldSheet::of(cues), std::clamp(cues.retraction_N / most_N - 1.0, 0.0, 1.0)));
    }
    showTarget(cues);
}

void TubeContent::showTarget(const core::LaparoscopyCues& cues) {
    if (const auto ring = markRing(m_parameters, cues))
        m_target->show(ring->p_W, ring->along, ring->radius_m, ring->foot, cues.dwell);
    else
        m_target->hide();
}

} // namespace chiron::scene3d
