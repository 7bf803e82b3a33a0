// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/landmark_marks.h"

#include "core/units.h"
#include "desktop/scene3d/parts/flat_shapes.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"

namespace chiron::scene3d {

namespace {

constexpr double kRadius_mm = 4.2;
constexpr double kHalf_mm = 0.28;
constexpr double kEdge_mm = 0.22;   // width of the black border of the bright line
constexpr float kInwards_mm = 1.2F; // in front of the wall, which is not flat

Qt3DRender::QParameter* uniform(const char* name, const QVariant& value, Qt3DCore::QNode* parent) {
    return new Qt3DRender::QParameter(QLatin1String(name), value, parent);
}

} // namespace

LandmarkMarks::LandmarkMarks(const UrethraDrawing& drawing, EffectShelf& effects, Qt3DCore::QEntity* anatomy)
    : m_entity(new Qt3DCore::QEntity(anatomy)), m_bright(uniform("tint", QVector4D(1, 1, 1, 1), m_entity)),
      m_dark(uniform("tint", QVector4D(0, 0, 0, 1), m_entity)) {
    for (const simulation::BladderLandmark& landmark : drawing.parameters().landmarks)
        add(drawing, landmark, effects);
    m_entity->setEnabled(false);
}

void LandmarkMarks::add(const UrethraDrawing& drawing, const simulation::BladderLandmark& landmark,
                        EffectShelf& effects) {
    auto* place = new Qt3DCore::QEntity(m_entity);
    auto* transform = new Qt3DCore::QTransform(place);
    const core::Vec3 in = -drawing.bladderDirection_A(landmark.polar_rad, landmark.azimuth_rad);
    // Upright as seen from the neck: y of the mark is the direction n at the neck, projected onto the wall.
    core::Vec3 up = drawing.bladderDirection_A(0.5 * core::kPi, 0.5 * core::kPi);
    up -= up.dot(in) * in;
    if (!(up.norm() > 1e-3))
        up = in.unitOrthogonal();
    up.normalize();
    core::Mat3 axes;
    axes << up.cross(in), up, in;
    transform->setTranslation(toMillimetres(drawing.landmark_A(landmark)) + kInwards_mm * toVector(in));
    transform->setRotation(toQuaternion(core::Quat(axes)));
    place->addComponent(transform);
    auto* whole = uniform("share", 2.0F, place);
    auto* bright = effects.materialWith("#define BOTH_SIDES\n", "mark.vert", "turn.frag", {m_bright, whole},
                                        Blend::opaque, place);
    auto* dark = effects.materialWith("#define BOTH_SIDES\n", "mark.vert", "turn.frag", {m_dark, whole},
                                      Blend::opaque, place);
    auto* tick = new Qt3DCore::QEntity(place);
    m_ticks.push_back(tick);
    const float size = float(0.62 * kRadius_mm);
    const auto lay = [](Part* part, float scale, float before) {
        part->at().setScale3D({scale, scale, 1.0F});
        part->at().setTranslation({0.0F, 0.0F, before});
    };
    lay(new Part(flatRing(kRadius_mm, kHalf_mm + kEdge_mm), dark, place), 1.0F, 0.0F);
    lay(new Part(flatRing(kRadius_mm, kHalf_mm), bright, place), 1.0F, 0.12F);
    lay(new Part(flatTick((kHalf_mm + kEdge_mm) / double(size)), dark, tick), size, 0.0F);
    lay(new Part(flatTick(kHalf_mm / double(size)), bright, tick), size, 0.12F);
    tick->setEnabled(false);
}

void LandmarkMarks::change(const SceneSetup& setup) {
    m_guided = setup.cues.guidance;
    m_bright->setValue(setup.colours.highContrast ? QVector4D(1, 1, 0, 1) : QVector4D(0.86F, 0.98F, 1.0F, 1));
}

void LandmarkMarks::show(const SceneState& state) {
    m_entity->setEnabled(m_guided && state.exercise.of<simulation::EndoscopeCues>().guided);
    for (std::size_t i = 0; i < m_ticks.size(); ++i)
        m_ticks[i]->setEnabled(i < 32 &&
                               (state.exercise.of<simulation::EndoscopeCues>().landmarksSeen >> i & 1U) != 0);
}

} // namespace chiron::scene3d
