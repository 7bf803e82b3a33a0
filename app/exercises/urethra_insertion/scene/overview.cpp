// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/overview.h"

#include "app/exercises/urethra_insertion/scene/lining_picture.h"
#include "app/exercises/urethra_insertion/scene/overview_fit.h"
#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/parts/cystoscope_mesh.h"
#include "desktop/scene3d/parts/flat_shapes.h"

#include <QMatrix4x4>
#include <algorithm>

namespace chiron::scene3d {

namespace {

const QVector4D kCanal(0.86F, 0.42F, 0.38F, 0.10F);
const QVector4D kBladder(0.88F, 0.56F, 0.48F, 0.06F);
const QVector4D kGlans(0.86F, 0.60F, 0.54F, 0.30F);
constexpr double kAnchored_m = 0.015; // length of canal before the neck that the pelvis holds in place
constexpr double kRule_mm = 10.0;     // spacing of the lines across the canal

Qt3DRender::QParameter* tintOf(Qt3DCore::QNode* parent) {
    return new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(0, 0, 0, 1), parent);
}

} // namespace

Overview::Overview(const UrethraModel& model, SharedLight& light, EndoscopeGraph& graph,
                   Qt3DCore::QEntity* root)
    : m_model(model), m_light(light), m_graph(graph), m_root(root), m_scope(new Qt3DCore::QEntity(root)),
      m_ghost(new Qt3DCore::QEntity(root)), m_ground(tintOf(root)),
      m_tip(new Qt3DRender::QParameter(QStringLiteral("tip"), QVector4D(0, 0, -1, -1), root)),
      m_ahead(new Qt3DRender::QParameter(QStringLiteral("ahead"), QVector4D(0, 0, 1, 1), root)),
      m_anchored(new Qt3DRender::QParameter(QStringLiteral("anchored"), QVector4D(0, 0, 1, 2), root)),
      m_ghostTint(tintOf(root)), m_arrow(new ForceArrow(light, root)),
      m_yields(light, graph.outsideOver(), root) {
    const simulation::AnatomyPose& pose = model.drawing().parameters().pose;
    for (bool glass : {false, true}) {
        auto* anatomy = new Qt3DCore::QEntity(root);
        auto* place = new Qt3DCore::QTransform(anatomy);
        place->setTranslation(toMillimetres(pose.p_WA));
        place->setRotation(toQuaternion(pose.q_WA));
        anatomy->addComponent(place);
        anatomy->addComponent(glass ? graph.glass() : graph.outside());
        const char* look = glass ? "#define BOTH_SIDES\n" : "#define CUT\n#define BOTH_SIDES\n";
        const Blend blend = glass ? Blend::translucent : Blend::opaque;
        model.addCoarseCanal(
            shell(look, "canal_outside.vert", kCanal, float(kCanalTile_mm / kRule_mm), blend), anatomy);
        model.addBladder(shell(look, "lining_outside.vert", kBladder, 0.0F, blend), anatomy);
        auto* glans = new Qt3DCore::QEntity(anatomy);
        m_glans[glass] = new Qt3DCore::QTransform(glans);
        glans->addComponent(m_glans[glass]);
        model.addGlans(shell(look, "lining_outside.vert", kGlans, 0.0F, blend), glans);
    }
    auto* ground = light.effects.material("screen.vert", "plain.frag", {m_ground}, Blend::opaque, root);
    (new Part(flatSquare(0.9999), ground, root))->addComponent(graph.outside());
    m_pose = addScope(false, m_scope);
    m_scope->addComponent(graph.outside());
    m_ghostPose = addScope(true, m_ghost);
    m_ghost->addComponent(graph.glass());
    m_arrow->addComponent(graph.outsideOver());
}

Qt3DRender::QMaterial* Overview::shell(const char* look, const char* vertexShader, const QVector4D& tint,
                                       float rule, Blend blend) {
    const auto own = [&](const char* name, const QVariant& value) {
        return new Qt3DRender::QParameter(QLatin1String(name), value, m_root);
    };
    const simulation::UrethraAnatomy& anatomy = m_model.drawing().parameters().anatomy;
    return m_light.effects.materialWith(
        look, vertexShader, "outside.frag",
        {own("tint", tint), own("rule", rule), m_tip, m_ahead, m_anchored,
         own("bend", QVector3D(float(2.0 * anatomy.curvature_per_m), float(kCanalTile_mm),
                               float(anatomy.straight_m)))},
        blend, m_root);
}

Qt3DCore::QTransform* Overview::addScope(bool ghost, Qt3DCore::QEntity* parent) {
    auto* pose = new Qt3DCore::QTransform(parent);
    parent->addComponent(pose);
    auto* tint = ghost ? m_ghostTint : tintOf(parent);
    if (!ghost)
        tint->setValue(QVector4D(1, 1, 1, 1));
    auto* material =
        m_light.effects.material("solid.vert", "instrument.frag", {m_light.lamp, m_light.outlined, tint},
                                 ghost ? Blend::translucent : Blend::opaque, m_root);
    new Part(cystoscopeMesh(m_model.drawing().parameters().endoscope.radius_m * 1e3), material, parent);
    parent->setEnabled(false);
    return pose;
}

void Overview::change(const SceneSetup& setup) {
    m_toolShown = setup.cues.tool;
    m_ground->setValue(toTint(setup.colours.field));
    m_ghostTint->setValue(toTint(setup.colours.ghost, 0.38F));
    m_arrow->change(setup);
    m_yields.change(setup);
    m_graph.setOverviewShown(setup.cues.overview);
}

void Overview::showScope(Qt3DCore::QEntity* scope, Qt3DCore::QTransform* pose, const ToolView& tool) {
    scope->setEnabled(tool.present);
    if (!tool.present)
        return;
    const UrethraDrawing& drawing = m_model.drawing();
    const core::Quat q_WT = drawing.parameters().pose.q_WA * core::Quat(drawing.axes_A(tool));
    pose->setTranslation(toMillimetres(drawnTip(tool)));
    pose->setRotation(toQuaternion(q_WT));
}

void Overview::followShaft(const ToolView& tool) {
    const UrethraDrawing& drawing = m_model.drawing();
    const simulation::UrethraDeformation now = drawing.deformationOf(tool);
    const bool around = now.inside && now.tip_s_m > 0.0;
    const core::Vec3 tip = around ? drawing.tip_A(tool) : core::Vec3(0, 0, -1);
    const core::Vec3 ahead =
        around ? core::Vec3(-drawing.axes_A(tool).col(2)) : core::Vec3(core::Vec3::UnitZ());
    const double neck = drawing.centreline().length_m();
    m_tip->setValue(QVector4D(toVector(tip), float(around ? now.tip_s_m : -1.0)));
    m_ahead->setValue(QVector4D(toVector(ahead), float(drawing.parameters().endoscope.behind_m)));
    m_anchored->setValue(QVector4D(float(now.ex_m), float(now.en_m), float(neck - kAnchored_m), float(neck)));
    // The glans is where the canal begins.
    const core::Vec3 meatus = around ? core::Vec3(tip - now.tip_s_m * ahead) : core::Vec3(core::Vec3::Zero());
    const core::Quat turn = core::Quat::FromTwoVectors(core::Vec3::UnitZ(), ahead);
    for (Qt3DCore::QTransform* glans : m_glans) {
        glans->setTranslation(toMillimetres(meatus));
        glans->setRotation(toQuaternion(turn));
    }
}

void Overview::show(const SceneState& state) {
    ToolView tool = state.tool[0];
    followShaft(tool);
    m_arrow->show(tool);
    tool.present = tool.present && m_toolShown;
    showScope(m_scope, m_pose, tool);
    showScope(m_ghost, m_ghostPose, state.ghost);
    m_yields.show(state);
}

void Overview::place(const QRect& overview) {
    const double aspect = double(std::max(1, overview.width())) / std::max(1, overview.height());
    const OverviewFit fit = fitOverview(m_model.drawing(), aspect);
    Qt3DRender::QCamera& camera = *m_graph.bystander();
    camera.lens()->setPerspectiveProjection(float(fit.fieldOfView_deg), float(aspect), 20.0F, 4000.0F);
    camera.setPosition(toMillimetres(fit.p_WEye));
    camera.setViewCenter(toMillimetres(fit.p_WTarget));
    camera.setUpVector(toVector(fit.up_W));
}

} // namespace chiron::scene3d
