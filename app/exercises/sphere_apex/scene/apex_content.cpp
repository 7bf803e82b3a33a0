// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/scene/apex_content.h"

#include "app/exercises/sphere_apex/scene/apex_mesh.h"
#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/plugin/skin_texture.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

#include <QMatrix4x4>
#include <algorithm>
#include <utility>

namespace chiron::scene3d {

namespace {

/// The cover has the drape's colour, slightly lighter, so that field and cover can be distinguished.
QVector4D coverColour(const SceneColours& colours) {
    if (!colours.highContrast)
        return toTint(colours.field.lighter(108));
    const QVector4D background = toTint(colours.background);
    return background + 0.24F * (toTint(colours.ink) - background);
}

} // namespace

Qt3DRender::QParameter* ApexContent::parameter(const char* name, const QVariant& value,
                                               Qt3DCore::QNode* parent) {
    return new Qt3DRender::QParameter(QLatin1String(name), value, parent);
}

ApexContent::ApexContent(const SceneSetup& setup, SharedLight& light, Qt3DCore::QEntity* parent)
    : m_parameters(setup.parameters.as<simulation::SphereApexParameters>()), m_setup(setup),
      m_surface(ApexSurface::of(m_parameters, SceneState{})), m_light(light) {
    m_dentPlace = parameter("dentPlace", QMatrix4x4() * 0.0F, parent);
    m_dentNormal = parameter("dentNormal", QMatrix4x4(), parent);
    m_tips = parameter("tips", QMatrix4x4() * 0.0F, parent);
    m_presses = parameter("presses", QMatrix4x4() * 0.0F, parent);
    m_plain = parameter("plain", coverColour(setup.colours), parent);
    auto* skin = parameter("skin", QVariant::fromValue(makeSkinTexture(parent)), parent);
    auto* material = new Qt3DRender::QMaterial(parent);
    for (Qt3DRender::QParameter* p :
         {light.lamp, light.lens, m_dentPlace, m_dentNormal, m_tips, m_presses, m_plain, skin})
        material->addParameter(p);
    m_part = new Part(apexMesh(m_surface), material, parent);
    chooseLook();
}

Qt3DRender::QEffect* ApexContent::look(bool shown) const {
    const char* look = !shown ? "cover.frag" : m_setup.colours.highContrast ? "outlined.frag" : "tissue.frag";
    return m_light.effects.effect("tissue.vert", look, Blend::opaque, std::max(1, m_tools));
}

void ApexContent::chooseLook() {
    Qt3DRender::QEffect* effect = look(m_surface.shown);
    if (m_part->material()->effect() != effect)
        m_part->material()->setEffect(effect);
    if (m_warm)
        (void)look(!m_surface.shown);
    m_plain->setValue(coverColour(m_setup.colours));
}

void ApexContent::warm() {
    m_warm = true;
    chooseLook();
}

void ApexContent::change(const SceneSetup& setup) {
    m_setup = setup;
    m_parameters = setup.parameters.as<simulation::SphereApexParameters>();
    chooseLook();
}

void ApexContent::show(const SceneState& state) {
    const ApexSurface surface = ApexSurface::of(m_parameters, state);
    if (!(surface == m_surface)) {
        m_surface = surface;
        m_part->mesh().setMesh(apexMesh(surface));
        chooseLook();
    }
    showTips(state);
}

void ApexContent::showTips(const SceneState& state) {
    QMatrix4x4 places = QMatrix4x4() * 0.0F;
    QMatrix4x4 normals;
    QMatrix4x4 tips = QMatrix4x4() * 0.0F;
    QMatrix4x4 presses = QMatrix4x4() * 0.0F;
    int tools = 0;
    for (std::size_t i = 0; i < state.tool.size() && m_setup.cues.tool; ++i) {
        const ToolView& tool = state.tool[i];
        if (!tool.present)
            continue;
        const int column = tools++;
        tips.setColumn(column, QVector4D(toMillimetres(drawnTip(tool)), 1.0F));
        // The surface is dented by the hand. If no force is felt, the tip stays on the surface and blanches
        // the tissue.
        const Dent dent = m_surface.dentUnder(tool);
        if (!tool.drawnAtSurface) {
            places.setColumn(column, QVector4D(toMillimetres(dent.p_WSurface), float(dent.depth_m * 1e3)));
            normals.setColumn(column, QVector4D(toVector(dent.normal), float(dent.reach_m * 1e3)));
        }
        const double press =
            m_surface.shown && dent.depth_m > 0.0
                ? std::clamp(tool.force_N.norm() / std::max(0.1, m_setup.forceLimit_N), 0.0, 1.0)
                : 0.0;
        presses.setColumn(column, QVector4D(toMillimetres(drawnTip(tool)),
                                            float(tool.drawnAtSurface ? press : 0.45 * press)));
    }
    m_dentPlace->setValue(places);
    m_dentNormal->setValue(normals);
    m_tips->setValue(tips);
    m_presses->setValue(presses);
    if (std::exchange(m_tools, tools) != tools)
        chooseLook();
}

} // namespace chiron::scene3d
