// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/scene/handling_content.h"

#include "app/exercises/object_handling/scene/squeezed.h"
#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/parts/floor_shade.h"
#include "desktop/scene3d/parts/loft.h"
#include "desktop/scene3d/parts/sweep.h"

#include <QMatrix4x4>

namespace chiron::scene3d {

namespace {

const OrganLook kOvary{{1.0F, 0.95F, 0.89F, 0.20F}, {0.95F, 0.83F, 0.77F, 0.40F}};
const OrganLook kOrgan{{0.68F, 0.30F, 0.26F, 0.25F}, {0.55F, 0.20F, 0.18F, 0.7F}};
constexpr std::uint32_t kOvarySeed = 23; // all objects of a level look alike

/// A lobed body of unit size, close to the ball that is felt.
TriangleMesh ovary() {
    TriangleMesh mesh;
    addLobe(mesh, core::Vec3::Zero(), {1.04, 0.99, 0.99}, 0.05, kOvarySeed, 22);
    for (MeshVertex& v : mesh.vertices)
        for (float& along : v.texture)
            along *= 11.0F; // the texture of the skin is in millimetres
    return mesh;
}

TriangleMesh dish(double radius_mm) {
    TriangleMesh mesh;
    addTurned(mesh,
              {{0.15, radius_mm - 1.0},
               {0.3, radius_mm + 1.5},
               {1.6, radius_mm + 3.0},
               {3.2, radius_mm + 3.8},
               {3.6, radius_mm + 3.4},
               {3.2, radius_mm + 2.9},
               {1.7, radius_mm + 2.0},
               {0.55, radius_mm},
               {0.35, radius_mm - 3.0},
               {0.3, 0.0}},
              1.0, 48);
    return mesh;
}

/// The closing direction of the blades of the jaw that holds the object: y of T.
core::Vec3 jawsOf(const core::BodyCue& body, const SceneState& state) {
    for (std::size_t i = 0; i < state.tool.size(); ++i)
        if ((body.heldBy >> i & 1) != 0)
            return state.tool[i].q_WT * core::Vec3::UnitY();
    return core::Vec3::UnitX();
}

} // namespace

HandlingContent::HandlingContent(const SceneSetup& setup, SharedLight& light, Qt3DCore::QEntity* parent)
    : m_parameters(setup.parameters.as<simulation::ObjectHandlingParameters>()),
      m_abdomen(new Abdomen(light, kFieldRadius_m, parent)) {
    auto* skin = m_abdomen->organ(kOvary, m_abdomen);
    for (Part*& body : m_body) {
        body = new Part(ovary(), skin, m_abdomen);
        body->setEnabled(false);
    }
    m_shade = new Part({}, m_abdomen->shade(m_abdomen), m_abdomen);
    auto* steel = new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(1, 1, 1, 1), m_abdomen);
    m_dish = new Part({},
                      light.effects.material("solid.vert", "instrument.frag",
                                             {light.lamp, light.outlined, steel}, Blend::opaque, m_abdomen),
                      m_abdomen);
    m_target = new TargetRing(light, m_abdomen);
    m_shade->setEnabled(false);
    m_dish->setEnabled(false);
    if (!m_parameters.organBed)
        return;
    m_organAtRest = organMesh(m_parameters);
    m_abdomen->lower(m_parameters.bedMesh.halfAxisZ_m);
    m_organ = new Part(m_organAtRest, m_abdomen->organ(kOrgan, m_abdomen), m_abdomen);
}

void HandlingContent::showOrgan(const SceneState& state) {
    if (!m_organ)
        return;
    const std::vector<Dent> dents = organDents(m_parameters, state);
    if (dents.empty() && !m_organDented)
        return;
    m_organDented = !dents.empty();
    m_organ->mesh().setMesh(dented(m_organAtRest, dents));
}

ContentFrame HandlingContent::frame() const {
    return {.fieldRadius_m = kFieldRadius_m, .roomAbove_m = 0.070, .draped = false};
}

void HandlingContent::putOn(const SceneLayers& layers) {
    m_shade->addComponent(layers.translucent);
    m_target->putTranslucent(layers.translucent);
}

void HandlingContent::change(const SceneSetup& setup) {
    m_parameters = setup.parameters.as<simulation::ObjectHandlingParameters>();
    m_abdomen->change(setup);
    m_target->change(setup);
}

void HandlingContent::show(const SceneState& state) {
    m_abdomen->show(state);
    showOrgan(state);
    showBodies(state);
    showDish(state.exercise.of<core::LaparoscopyCues>());
}

void HandlingContent::showBodies(const SceneState& state) {
    const core::LaparoscopyCues& cues = state.exercise.of<core::LaparoscopyCues>();
    TriangleMesh shade;
    for (std::size_t i = 0; i < m_body.size(); ++i) {
        const bool shown = cues.present && cues.objectShown && static_cast<int>(i) < cues.bodies;
        m_body[i]->setEnabled(shown);
        if (!shown)
            continue;
        const core::BodyCue& body = cues.body[i];
        const core::Vec3 p_W(body.p_W[0], body.p_W[1], body.p_W[2]);
        const core::Mat3 map = squeezed(body, jawsOf(body, state)) * 1e3;
        QMatrix4x4 matrix;
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                matrix(row, column) = float(map(row, column));
            matrix(row, 3) = float(p_W[row] * 1e3);
        }
        m_body[i]->at().setMatrix(matrix);
        if (!m_organ)
            addShade(shade, p_W, body.radius_m, 0.0);
    }
    m_shade->setEnabled(!shade.indices.empty());
    if (!shade.indices.empty())
        m_shade->mesh().setMesh(shade);
}

void HandlingContent::showDish(const core::LaparoscopyCues& cues) {
    const bool shown = cues.present && cues.objectShown && cues.targetShown && cues.targetRadius_m > 0.0;
    m_dish->setEnabled(shown && !m_organ);
    if (!shown) {
        m_target->hide();
        return;
    }
    if (m_dishRadius_m != cues.targetRadius_m) {
        m_dishRadius_m = cues.targetRadius_m;
        m_dish->mesh().setMesh(dish(m_dishRadius_m * 1e3));
    }
    const core::Vec3 p_W(cues.p_WTarget[0], cues.p_WTarget[1], cues.p_WTarget[2]);
    m_dish->at().setTranslation(toMillimetres({p_W.x(), p_W.y(), 0.0}));
    m_target->show({p_W.x(), p_W.y(), groundHeight_m(p_W.x(), p_W.y()) + 0.0012}, core::Vec3::UnitZ(),
                   m_dishRadius_m - 0.001, false, cues.dwell);
}

} // namespace chiron::scene3d
