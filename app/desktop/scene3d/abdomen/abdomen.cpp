// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/abdomen/abdomen.h"

#include "desktop/scene3d/abdomen/abdomen_mesh.h"
#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/parts/dent.h"
#include "desktop/scene3d/plugin/skin_texture.h"

#include <QMatrix4x4>
#include <QVariant>
#include <algorithm>
#include <utility>

namespace chiron::scene3d {

namespace {

const OrganLook kBowel{{0.95F, 0.66F, 0.60F, 0.60F}, {0.86F, 0.50F, 0.47F, 0.55F}};
const OrganLook kFat{{0.97F, 0.86F, 0.62F, 0.35F}, {0.93F, 0.74F, 0.48F, 0.30F}};
const OrganLook kUterus{{0.90F, 0.55F, 0.52F, 0.5F}, {0.80F, 0.43F, 0.42F, 0.6F}};

} // namespace

Abdomen::Abdomen(SharedLight& light, double workspace_m, Qt3DCore::QNode* parent)
    : QEntity(parent), m_light(light), m_ground(new Qt3DCore::QEntity(this)),
      m_height(new Qt3DCore::QTransform(m_ground)) {
    m_ground->addComponent(m_height);
    m_skin = parameter("skin", QVariant::fromValue(makeSkinTexture(this)));
    m_dentPlace = parameter("dentPlace", QMatrix4x4() * 0.0F);
    m_dentNormal = parameter("dentNormal", QMatrix4x4());
    m_tips = parameter("tips", QMatrix4x4() * 0.0F);
    auto* presses = parameter("presses", QMatrix4x4() * 0.0F);
    auto* floor = new Qt3DRender::QMaterial(this);
    for (Qt3DRender::QParameter* p :
         {light.lamp, light.lens, m_dentPlace, m_dentNormal, m_tips, presses, m_skin})
        floor->addParameter(p);
    const double workspace_mm = workspace_m * 1e3;
    m_floor = new Part(peritoneumMesh(workspace_mm), floor, m_ground);
    chooseLook();
    new Part(bowelMesh(workspace_mm), organ(kBowel, this), m_ground);
    new Part(fatMesh(workspace_mm), organ(kFat, this), m_ground);
    new Part(uterusMesh(workspace_mm), organ(kUterus, this), m_ground);
}

Qt3DRender::QParameter* Abdomen::parameter(const char* name, const QVariant& value) {
    return new Qt3DRender::QParameter(QLatin1String(name), value, this);
}

Qt3DRender::QMaterial* Abdomen::organ(const OrganLook& look, Qt3DCore::QNode* parent) {
    return m_light.effects.material("organ.vert", "organ.frag",
                                    {m_light.lamp, m_light.lens, m_light.outlined, m_skin,
                                     parameter("pale", look.pale), parameter("deep", look.deep)},
                                    Blend::opaque, parent);
}

Qt3DRender::QMaterial* Abdomen::shade(Qt3DCore::QNode* parent) {
    return m_light.effects.material("organ.vert", "shade.frag", {m_light.lamp, m_light.lens},
                                    Blend::translucent, parent);
}

void Abdomen::lower(double by_m) {
    m_height->setTranslation({0.0F, 0.0F, -float(by_m * 1e3)});
}

void Abdomen::chooseLook() {
    Qt3DRender::QEffect* effect =
        m_light.effects.effect("tissue.vert", m_setup.colours.highContrast ? "outlined.frag" : "tissue.frag",
                               Blend::opaque, std::max(1, m_tools));
    if (m_floor->material()->effect() != effect)
        m_floor->material()->setEffect(effect);
}

void Abdomen::change(const SceneSetup& setup) {
    m_setup = setup;
    chooseLook();
}

void Abdomen::show(const SceneState& state) {
    QMatrix4x4 places = QMatrix4x4() * 0.0F;
    QMatrix4x4 normals;
    QMatrix4x4 tips = QMatrix4x4() * 0.0F;
    int tools = 0;
    for (std::size_t i = 0; i < state.tool.size() && m_setup.cues.tool; ++i) {
        const ToolView& tool = state.tool[i];
        if (!tool.present)
            continue;
        const core::Vec3 tip = drawnTip(tool);
        const int column = tools++;
        tips.setColumn(column, QVector4D(toMillimetres(tip), 1.0F));
        const double depth_m = std::clamp(-tip.z(), 0.0, 0.012);
        places.setColumn(column, QVector4D(toMillimetres({tip.x(), tip.y(), 0.0}), float(depth_m * 1e3)));
        normals.setColumn(
            column,
            QVector4D(0.0F, 0.0F, 1.0F, float(1e3 * (Dent::kBaseReach_m + Dent::kReachPerDepth * depth_m))));
    }
    m_dentPlace->setValue(places);
    m_dentNormal->setValue(normals);
    m_tips->setValue(tips);
    if (std::exchange(m_tools, tools) != tools)
        chooseLook();
}

} // namespace chiron::scene3d
