// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/place_marks.h"

#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/parts/loft.h"
#include "desktop/scene3d/scene_marks.h"

#include <algorithm>

namespace chiron::scene3d {

namespace {

constexpr double kLeastHeight_mm = 1.5; // below this height the shadow is sufficient

TriangleMesh lineMesh() {
    TriangleMesh mesh;
    addTurned(mesh, {{0.0, 0.28}, {1.0, 0.28}}, 0.0, 8);
    return mesh;
}

TriangleMesh pinMesh() {
    TriangleMesh mesh;
    addTurned(mesh, {{0.0, 0.05}, {2.0, 0.5}, {15.0, 0.5}}, 0.0, 12);
    addTurned(mesh,
              {{14.0, 0.0}, {14.5, 1.9}, {16.0, 3.0}, {18.0, 3.4}, {20.0, 3.0}, {21.5, 1.9}, {22.0, 0.0}},
              0.0, 20);
    return mesh;
}

} // namespace

PlaceMarks::PlaceMarks(SharedLight& light, Qt3DCore::QNode* parent)
    : QEntity(parent),
      m_lineTint(new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(0, 0, 0, 1), this)),
      m_pinTint(new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(0, 0, 0, 1), this)),
      m_pin(new Qt3DCore::QEntity(this)), m_pinAt(new Qt3DCore::QTransform(m_pin)),
      m_answer(new Qt3DCore::QEntity(this)), m_answerAt(new Qt3DCore::QTransform(m_answer)) {
    auto* line = light.effects.material("solid.vert", "signal.frag", {m_lineTint}, Blend::opaque, this);
    auto* pin = light.effects.material("solid.vert", "signal.frag", {m_pinTint}, Blend::opaque, this);
    for (int i = 0; i < core::kMaxTools; ++i) {
        m_line[i] = new Part(lineMesh(), line, this);
        m_foot[i] = new Part(ringMesh(2.2, 0.28), line, this);
        m_line[i]->setEnabled(false);
        m_foot[i]->setEnabled(false);
    }
    m_pin->addComponent(m_pinAt);
    new Part(pinMesh(), pin, m_pin);
    m_pin->setEnabled(false);
    m_answer->addComponent(m_answerAt);
    for (const double radius_mm : kAnswerRings_mm)
        new Part(ringMesh(radius_mm, 0.5), line, m_answer);
    m_answer->setEnabled(false);
}

void PlaceMarks::change(const SceneSetup& setup) {
    m_setup = setup;
    m_lineTint->setValue(toTint(setup.colours.ink));
    m_pinTint->setValue(toTint(setup.colours.arrow));
}

void PlaceMarks::show(const SceneState& state, const ISceneContent& content) {
    for (std::size_t i = 0; i < state.tool.size(); ++i) {
        const core::Vec3 from = setDownBy(state, i);
        const double ground_m = content.groundHeight_m(from.x(), from.y());
        const double height_mm = (from.z() - ground_m) * 1e3;
        const bool drawn = state.tool[i].present && m_setup.cues.tool && height_mm > kLeastHeight_mm;
        m_line[i]->setEnabled(drawn);
        m_foot[i]->setEnabled(drawn);
        if (!drawn)
            continue;
        const QVector3D foot = toMillimetres({from.x(), from.y(), ground_m});
        m_line[i]->at().setTranslation(foot);
        m_line[i]->at().setScale3D({1.0F, 1.0F, float(height_mm)});
        m_foot[i]->at().setTranslation(foot + QVector3D(0.0F, 0.0F, 0.3F));
    }
    m_answer->setEnabled(state.answered);
    if (state.answered)
        m_answerAt->setTranslation(toMillimetres(state.p_WAnswer) + QVector3D(0.0F, 0.0F, 0.5F));
    m_pin->setEnabled(state.marked);
    if (!state.marked)
        return;
    // The tip was pressed into the tissue when it marked. The pin stands on the surface above that position.
    core::Vec3 p = state.p_WMark;
    p.z() = std::max(p.z(), content.groundHeight_m(p.x(), p.y()));
    m_pinAt->setTranslation(toMillimetres(p));
}

} // namespace chiron::scene3d
