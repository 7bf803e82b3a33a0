// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/finger.h"

#include "app/exercises/palpation/scene/hand_mesh.h"
#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/parts/instrument_mesh.h"
#include "desktop/scene3d/parts/loft.h"

#include <QMatrix4x4>
#include <QtMath>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

const QColor kRightGlove(58, 116, 190);
const QColor kLeftGlove(142, 104, 186);
constexpr double kSolidFrom = 0.995; // opacity from which on a glove is drawn as opaque

TriangleMesh coneMesh() {
    TriangleMesh mesh;
    addTurned(mesh, {{0.0, 2.6}, {1.0, 0.02}}, 0.0, 16);
    return mesh;
}

Qt3DRender::QParameter* tint(const QVector4D& value, Qt3DCore::QNode* parent) {
    return new Qt3DRender::QParameter(QStringLiteral("tint"), value, parent);
}

core::Quat heldLike(const ToolView& tool) {
    return tool.q_WT.norm() > 0.5 ? tool.q_WT.normalized() : core::Quat::Identity();
}

core::Quat turned(const core::Quat& q, double yaw_rad) {
    return q * core::Quat(Eigen::AngleAxisd(yaw_rad, core::Vec3::UnitZ()));
}

} // namespace

Finger::Finger(SharedLight& light, Qt3DRender::QParameter* skin, int index, int fingers,
               Qt3DCore::QNode* parent)
    : QEntity(parent), m_index(index), m_body(new Qt3DCore::QEntity(this)) {
    m_pose = new Qt3DCore::QTransform(m_body);
    m_body->addComponent(m_pose);
    m_pale = new Qt3DRender::QParameter(QStringLiteral("pale"), QVector4D(), this);
    m_deep = new Qt3DRender::QParameter(QStringLiteral("deep"), QVector4D(), this);
    m_leanTint = tint({0, 0, 0, 1}, this);
    const auto signal = [&](Qt3DRender::QParameter* colour, Blend blend) {
        return light.effects.material("solid.vert", "signal.frag", {colour}, blend, this);
    };
    auto* steel =
        light.effects.material("solid.vert", "instrument.frag",
                               {light.lamp, light.outlined, tint({1, 1, 1, 1}, this)}, Blend::opaque, this);
    m_opacity = new Qt3DRender::QParameter(QStringLiteral("opacity"), 1.0F, this);
    m_solid = makeGlove(light.effects.material("organ.vert", "organ.frag",
                                               {light.lamp, light.lens, light.outlined, skin, m_pale, m_deep},
                                               Blend::opaque, this),
                        fingers);
    m_glass = makeGlove(
        light.effects.materialWith("#define GLASS\n", "organ.vert", "organ.frag",
                                   {light.lamp, light.lens, light.outlined, skin, m_pale, m_deep, m_opacity},
                                   Blend::translucent, this),
        fingers);
    auto* band = signal(tint(toTint(ringColour(index)), this), Blend::opaque);
    for (int i = 0; i < core::kMaxTools; ++i) {
        m_bands[i] = new Part(fingerBands(i + 1), band, m_body);
        m_bands[i]->setEnabled(false);
    }
    m_collar = new Part(fingerCollar(), signal(tint({1, 1, 1, 1}, this), Blend::opaque), m_body);
    m_ring = new Part(ringMesh(kPlatformRing_mm, 0.75), steel, this);
    auto* lean = signal(m_leanTint, Blend::opaque);
    m_stop = new Part(ringMesh(kPlatformRing_mm + 2.0, 0.55), lean, this);
    m_cone = new Part(coneMesh(), lean, this);
    for (Part*& blade : m_blade)
        blade = new Part(instrumentJaw(), steel, this);
    setEnabled(false);
}

Finger::Glove Finger::makeGlove(Qt3DRender::QMaterial* material, int fingers) {
    Glove glove;
    glove.finger = new Part(fingerMesh(), material, m_body);
    for (int left = 0; left < 2 && m_index % std::max(1, fingers) == 0; ++left)
        glove.hand[left] = new Part(handMesh(fingers, left == 1), material, m_body);
    return glove;
}

void Finger::showGlove(const Glove& glove, bool shown) {
    const bool left = isLeftHand(m_setup, static_cast<std::size_t>(m_index));
    glove.finger->setEnabled(shown);
    for (int side = 0; side < 2 && glove.hand[side]; ++side)
        glove.hand[side]->setEnabled(shown && left == (side == 1));
}

void Finger::putTranslucent(Qt3DRender::QLayer* layer) {
    for (Part* part : {m_glass.finger, m_glass.hand[0], m_glass.hand[1]})
        if (part)
            part->addComponent(layer);
}

void Finger::change(const SceneSetup& setup) {
    m_setup = setup;
    const bool left = isLeftHand(setup, static_cast<std::size_t>(m_index));
    const QColor glove = left ? kLeftGlove : kRightGlove;
    QVector4D pale = toTint(glove.lighter(116));
    QVector4D deep = toTint(glove);
    pale.setW(0.0F); // no vessels show
    deep.setW(0.42F);
    m_pale->setValue(pale);
    m_deep->setValue(deep);
    showGlove(m_solid, true);
    showGlove(m_glass, false);
}

void Finger::show(const ToolView& tool, const FingerLean& lean, const Look& look) {
    setEnabled(true);
    const bool solid = look.opacity > kSolidFrom;
    showGlove(m_solid, solid);
    showGlove(m_glass, !solid);
    m_opacity->setValue(float(look.opacity));
    m_pose->setTranslation(toMillimetres(drawnTip(tool)));
    m_pose->setRotation(
        toQuaternion(turned(heldLike(tool), fingerYaw_rad(m_setup, static_cast<std::size_t>(m_index)))));
    for (int i = 0; i < core::kMaxTools; ++i)
        m_bands[i]->setEnabled(i + 1 == look.bands);
    m_collar->setEnabled(look.collar);
    showPlatform(tool, lean);
    showBlades(tool);
}

void Finger::showBlades(const ToolView& tool) {
    const bool shown = hasJaw(m_setup, static_cast<std::size_t>(m_index)) && tool.jaw_rad > kDrawnJaw_rad;
    for (int side = 0; side < 2; ++side) {
        m_blade[side]->setEnabled(shown);
        if (!shown)
            continue;
        QMatrix4x4 matrix;
        matrix.translate(toMillimetres(drawnTip(tool)));
        matrix.rotate(toQuaternion(heldLike(tool)));
        matrix.rotate(90.0F + 180.0F * float(side), 0.0F, 0.0F, 1.0F); // perpendicular to the finger
        matrix.translate(0.0F, 0.0F, float(kHinge_mm));
        // The blades turn in the same way as those of Instrument.
        matrix.rotate(qRadiansToDegrees(0.5F * float(tool.jaw_rad)), 1.0F, 0.0F, 0.0F);
        matrix.translate(0.0F, 0.0F, -float(kHinge_mm));
        m_blade[side]->at().setMatrix(matrix);
    }
}

void Finger::showPlatform(const ToolView& tool, const FingerLean& lean) {
    const core::Vec3 up = heldLike(tool) * core::Vec3::UnitZ();
    const core::Vec3 level = lean.toward - lean.toward.dot(up) * up;
    const bool leans = level.norm() > 1e-6;
    const core::Vec3 toward = leans ? core::Vec3(level.normalized()) : core::Vec3(core::Vec3::UnitX());
    const double angle = leans ? lean.angle_rad : 0.0;
    const core::Vec3 axis = std::cos(angle) * up + std::sin(angle) * toward;
    // Along the ring, in the direction of the lean.
    const core::Vec3 down = std::cos(angle) * toward - std::sin(angle) * up;
    const core::Vec3 middle = drawnTip(tool) + 1e-3 * kPlatformHeight_mm * up;
    const QQuaternion upright = QQuaternion::rotationTo(QVector3D(0, 0, 1), toVector(axis));
    for (Part* ring : {m_ring, m_stop}) {
        ring->at().setTranslation(toMillimetres(middle));
        ring->at().setRotation(upright);
    }
    m_stop->setEnabled(leans && lean.saturated);
    m_cone->setEnabled(leans);
    m_leanTint->setValue(toTint(lean.saturated ? m_setup.colours.over : m_setup.colours.arrow));
    m_cone->at().setTranslation(toMillimetres(middle + 1e-3 * (kPlatformRing_mm + 0.4) * down));
    m_cone->at().setRotation(QQuaternion::rotationTo(QVector3D(0, 0, 1), toVector(down)));
    m_cone->at().setScale3D({1.0F, 1.0F, float(3.0 + 9.0 * angle / kMostLean_rad)});
}

GhostFinger::GhostFinger(SharedLight& light, Qt3DCore::QNode* parent)
    : QEntity(parent), m_pose(new Qt3DCore::QTransform(this)), m_tint(tint({0, 0, 0, 1}, this)) {
    addComponent(m_pose);
    auto* material = light.effects.material("solid.vert", "signal.frag", {m_tint}, Blend::translucent, this);
    new Part(fingerMesh(), material, this);
    setEnabled(false);
}

void GhostFinger::change(const SceneSetup& setup) {
    m_setup = setup;
    m_tint->setValue(toTint(setup.colours.ghost, 0.45F));
}

void GhostFinger::show(const ToolView& tool) {
    setEnabled(tool.present);
    m_pose->setTranslation(toMillimetres(drawnTip(tool)));
    m_pose->setRotation(toQuaternion(turned(heldLike(tool), fingerYaw_rad(m_setup, 0))));
}

} // namespace chiron::scene3d
