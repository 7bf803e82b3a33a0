// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/finding_pins.h"

#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "desktop/scene3d/parts/loft.h"

#include <QVariant>
#include <QtMath>

namespace chiron::scene3d {

namespace {

constexpr double kStick_mm = 13.0;
constexpr float kFlag_mm = 13.0F; // includes the margin for the frame of the selected one
constexpr int kFlag_px = 96;
constexpr double kReachHalf_mm = 0.22; // half the width of the line

TriangleMesh stick() {
    TriangleMesh mesh;
    addTurned(mesh, {{0.0, 0.05}, {1.6, 0.55}, {kStick_mm, 0.55}}, 0.0, 10);
    return mesh;
}

TriangleMesh square() {
    TriangleMesh mesh;
    for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}})
        mesh.vertices.push_back(
            {{kFlag_mm * (x - 0.5F), kFlag_mm * (y - 0.5F), 0.0F}, {0.0F, 0.0F, 1.0F}, {x, y}, 1.0F});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

} // namespace

FindingPins::FindingPins(SharedLight& light, double elevation_rad, const simulation::TissueSurface& surface,
                         double reach_m, Qt3DCore::QNode* parent)
    : QEntity(parent), m_surface(surface),
      m_stickTint(new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(0, 0, 0, 1), this)) {
    auto* material = light.effects.material("solid.vert", "signal.frag", {m_stickTint}, Blend::opaque, this);
    for (Pin& pin : m_pins) {
        pin.root = new Qt3DCore::QEntity(this);
        pin.at = new Qt3DCore::QTransform(pin.root);
        pin.root->addComponent(pin.at);
        new Part(stick(), material, pin.root);
        pin.face = new PaintedFace(pin.root);
        auto* face = new Qt3DRender::QParameter(QStringLiteral("face"),
                                                QVariant::fromValue(pin.face->texture()), pin.root);
        pin.flag =
            new Part(square(),
                     light.effects.material("mark.vert", "face.frag", {face}, Blend::premultiplied, pin.root),
                     pin.root);
        pin.flag->at().setTranslation({0.0F, 0.0F, float(kStick_mm + 4.0)});
        pin.flag->at().setRotation(
            QQuaternion::fromAxisAndAngle(1.0F, 0.0F, 0.0F, 90.0F - float(qRadiansToDegrees(elevation_rad))));
        pin.reach = new Part(ringMesh(1e3 * reach_m, kReachHalf_mm), material, pin.root);
        pin.root->setEnabled(false);
    }
}

void FindingPins::putOver(Qt3DRender::QLayer* layer) {
    for (Pin& pin : m_pins) {
        pin.flag->addComponent(layer);
        pin.reach->addComponent(layer);
    }
}

void FindingPins::change(const SceneSetup& setup) {
    m_setup = setup;
    m_stickTint->setValue(toTint(setup.colours.ink));
    for (Pin& pin : m_pins)
        pin.painted = false;
}

void FindingPins::show(const SceneState& state) {
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    for (std::size_t i = 0; i < m_pins.size(); ++i) {
        Pin& pin = m_pins[i];
        const simulation::Finding& finding = cues.finding[i];
        const bool shown = cues.present && finding.present;
        pin.root->setEnabled(shown);
        if (!shown)
            continue;
        const core::Vec3 place(finding.p_W[0], finding.p_W[1], finding.p_W[2]);
        pin.at->setTranslation(toMillimetres(place));
        pin.reach->at().setRotation(
            QQuaternion::rotationTo(QVector3D(0, 0, 1), toVector(m_surface.normalAt(place.head<2>()))));
        const FindingFlag flag{static_cast<int>(i) + 1, state.overlay.of<PalpationOverlay>().outcome[i],
                               cues.selected == static_cast<int>(i)};
        if (pin.painted && pin.shown == flag)
            continue;
        pin.painted = true;
        pin.shown = flag;
        pin.face->change(QSize(kFlag_px, kFlag_px), [flag, setup = m_setup](QPainter& painter) {
            paintFindingFlag(painter, QRectF(0, 0, kFlag_px, kFlag_px), flag, setup);
        });
    }
}

} // namespace chiron::scene3d
