// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/palpation_scene_content.h"

#include "app/exercises/palpation/scene/map_picture.h"
#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "app/exercises/palpation/scene/tissue_mesh.h"
#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/plugin/skin_texture.h"

#include <QMatrix4x4>
#include <QPainter>
#include <QVector2D>
#include <algorithm>
#include <cmath>
#include <utility>

namespace chiron::scene3d {

namespace {

constexpr double kElevation_rad = 57.0 * core::kPi / 180.0; // steep enough to show the area beyond a finger
constexpr double kOpening_m = 0.010;                        // of the drape beyond the field, as in SceneStage
constexpr double kUnderDrape_m = 0.0125;

/// Colours (r, g, b) of pale and deep tissue; pale.w: vessels, deep.w: wetness; grain: roughness of the wet
/// film.
struct Paint {
    QVector4D pale;
    QVector4D deep;
    float grain;
};

Paint paintOf(TissueLook look) {
    switch (look) {
    case TissueLook::pad:
        return {{0.93F, 0.755F, 0.645F, 0.0F}, {0.905F, 0.715F, 0.60F, 0.20F}, 0.04F};
    case TissueLook::gland:
        return {{0.88F, 0.53F, 0.48F, 0.55F}, {0.78F, 0.40F, 0.37F, 0.50F}, 0.34F};
    case TissueLook::skin:
        return {{0.93F, 0.755F, 0.66F, 0.10F}, {0.875F, 0.665F, 0.57F, 0.10F}, 0.16F};
    }
    return {};
}

} // namespace

PalpationContent::PalpationContent(const SceneSetup& setup, SharedLight& light, Qt3DCore::QEntity* parent)
    : m_setup(setup), m_parameters(setup.parameters.as<simulation::PalpationParameters>()),
      m_surface(m_parameters.tissue.shape), m_light(light), m_root(parent), m_map(new PaintedFace(parent)),
      m_card(new MapCard(light, parent)),
      m_pins(new FindingPins(light, kElevation_rad, m_surface, m_parameters.hitRadius_m, parent)),
      m_ghost(new GhostFinger(light, parent)) {
    m_dentPlace = parameter("dentPlace", QMatrix4x4() * 0.0F);
    m_dentNormal = parameter("dentNormal", QMatrix4x4());
    m_tips = parameter("tips", QMatrix4x4() * 0.0F);
    m_presses = parameter("presses", QMatrix4x4() * 0.0F);
    m_lumpsNear = parameter("lumpsNear", QMatrix4x4() * 0.0F);
    m_lumpsFar = parameter("lumpsFar", QMatrix4x4() * 0.0F);
    m_skin = parameter("skin", QVariant::fromValue(makeSkinTexture(parent)));
    makeTissue();
    for (std::size_t i = 0; i < m_fingers.size(); ++i)
        m_fingers[i] = new Finger(light, m_skin, static_cast<int>(i), m_parameters.fingers, parent);
}

Qt3DRender::QParameter* PalpationContent::parameter(const char* name, const QVariant& value) {
    return new Qt3DRender::QParameter(QLatin1String(name), value, m_root);
}

void PalpationContent::makeTissue() {
    const Paint paint = paintOf(tissueLookOf(m_parameters.tissue));
    const Areola areola = areolaOf(m_parameters.tissue);
    const QVector4D ring(float(1e3 * areola.centre_m.x()), float(1e3 * areola.centre_m.y()),
                         float(std::max(1e-3, 1e3 * areola.radius_m)), paint.grain);
    const core::Vec2 scale = 0.5e-3 * m_parameters.areaHalf_m.cwiseInverse();
    auto* material = new Qt3DRender::QMaterial(m_root);
    for (Qt3DRender::QParameter* p :
         {m_light.lamp, m_light.lens, m_dentPlace, m_dentNormal, m_tips, m_presses, m_skin, m_lumpsNear,
          m_lumpsFar, parameter("pale", paint.pale), parameter("deep", paint.deep), parameter("areola", ring),
          parameter("surfaceMap", QVariant::fromValue(m_map->texture())),
          parameter("mapScale", QVector2D(float(scale.x()), float(scale.y())))})
        material->addParameter(p);
    m_tissue = new Part(tissueMesh(m_surface, fieldRadius_m() + kUnderDrape_m), material, m_root);
    m_border = parameter("plain", QVector4D());
    auto* border = new Qt3DRender::QMaterial(m_root);
    for (Qt3DRender::QParameter* p :
         {m_light.lamp, m_light.lens, m_dentPlace, m_dentNormal, m_tips, m_presses, m_border})
        border->addParameter(p);
    m_area = new Part(areaMesh(m_surface, m_parameters.areaHalf_m, 0.7), border, m_root);
    chooseLook();
}

double PalpationContent::fieldRadius_m() const {
    return palpationField_m(m_parameters);
}

ContentFrame PalpationContent::frame() const {
    const double plane_m = std::max(rimHeight_m(m_surface, fieldRadius_m() + kOpening_m),
                                    rimHeight_m(m_surface, fieldRadius_m() + kUnderDrape_m));
    return {.fieldRadius_m = fieldRadius_m(),
            .planeHeight_m = plane_m,
            .roomAbove_m = std::max(0.0, m_surface.highest_m() - plane_m) + 0.018,
            .elevation_rad = kElevation_rad,
            .ownTools = true};
}

void PalpationContent::putOn(const SceneLayers& layers) {
    m_ghost->putTranslucent(layers.translucent);
    for (Finger* finger : m_fingers) {
        finger->putTranslucent(layers.translucent);
        finger->putOver(layers.over);
    }
    m_card->addComponent(layers.translucent);
    m_pins->putOver(layers.over);
}

Qt3DRender::QEffect* PalpationContent::look(bool map) const {
    QByteArray defines;
    if (m_setup.colours.highContrast)
        defines += tissueLookOf(m_parameters.tissue) == TissueLook::skin ? "#define OUTLINED 5.0\n"
                                                                         : "#define OUTLINED 2.5\n";
    if (map)
        defines += "#define MAP\n";
    if (m_lumps > 0)
        defines += m_lumps > 3 ? "#define LUMPS 6\n" : "#define LUMPS 3\n";
    return m_light.effects.effect("tissue.vert", "skin.frag", Blend::opaque, std::max(1, m_tools), defines);
}

void PalpationContent::chooseLook() {
    const auto wear = [](Part* part, Qt3DRender::QEffect* effect) {
        if (part->material()->effect() != effect)
            part->material()->setEffect(effect);
    };
    wear(m_tissue, look(m_mapShown));
    wear(m_area, m_light.effects.effect("tissue.vert", "cover.frag", Blend::opaque, std::max(1, m_tools)));
    if (m_warm)
        (void)look(!m_mapShown);
}

void PalpationContent::warm() {
    m_warm = true;
    chooseLook();
}

void PalpationContent::change(const SceneSetup& setup) {
    m_setup = setup;
    m_mapPainted = false;
    m_border->setValue(setup.colours.highContrast ? QVector4D(0.0F, 0.0F, 0.0F, 1.0F)
                                                  : QVector4D(0.20F, 0.22F, 0.28F, 1.0F));
    m_card->change(setup);
    m_pins->change(setup);
    m_ghost->change(setup);
    for (Finger* finger : m_fingers)
        finger->change(setup);
    chooseLook();
}

void PalpationContent::show(const SceneState& state) {
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    const int tools = m_setup.cues.tool ? toolsOf(state) : 0;
    const int lumps =
        cues.present ? std::clamp(cues.lumps, 0, static_cast<int>(simulation::kMaxShownLumps)) : 0;
    const bool map = state.overlay.of<PalpationOverlay>().map != nullptr;
    const bool other =
        std::exchange(m_tools, tools) != tools || std::exchange(m_lumps, lumps) != lumps || m_mapShown != map;
    m_mapShown = map;
    if (other)
        chooseLook();
    showTouch(state);
    showLumps(state);
    showMap(state);
    m_pins->show(state);
    showFingers(state);
}

void PalpationContent::showTouch(const SceneState& state) {
    QMatrix4x4 places = QMatrix4x4() * 0.0F;
    QMatrix4x4 normals;
    QMatrix4x4 tips = QMatrix4x4() * 0.0F;
    QMatrix4x4 presses = QMatrix4x4() * 0.0F;
    int column = 0;
    for (const ToolView& tool : state.tool) {
        if (!tool.present || !m_setup.cues.tool)
            continue;
        const Dent dent = fingerDent(m_surface, m_parameters.tissue.contactRadius_m, tool);
        places.setColumn(column, QVector4D(toMillimetres(dent.p_WSurface), float(dent.depth_m * 1e3)));
        normals.setColumn(column, QVector4D(toVector(dent.normal), float(dent.reach_m * 1e3)));
        const double press = std::clamp(tool.force_N.norm() / std::max(0.1, m_setup.forceLimit_N), 0.0, 1.0);
        tips.setColumn(column, QVector4D(toMillimetres(drawnTip(tool)), 1.0F));
        presses.setColumn(column, QVector4D(toMillimetres(drawnTip(tool)),
                                            float(tool.drawnAtSurface ? press : 0.6 * press)));
        ++column;
    }
    m_dentPlace->setValue(places);
    m_dentNormal->setValue(normals);
    m_tips->setValue(tips);
    m_presses->setValue(presses);
}

void PalpationContent::showLumps(const SceneState& state) {
    QMatrix4x4 lumps[2] = {QMatrix4x4() * 0.0F, QMatrix4x4() * 0.0F};
    for (int i = 0; i < m_lumps; ++i) {
        const simulation::LumpCue& lump = state.exercise.of<simulation::PalpationCues>().lump[std::size_t(i)];
        const bool missed = (state.overlay.of<PalpationOverlay>().lumpsMissed >> i & 1) != 0;
        const core::Vec3 centre(lump.p_W[0], lump.p_W[1], lump.p_W[2]);
        // Where it is felt and marked: drawn at its own depth, it would appear beside that point.
        const core::Vec3 above = m_surface.nearest(centre, centre.head<2>()).p_W;
        lumps[i / 3].setColumn(i % 3,
                               QVector4D(toMillimetres(above), float((missed ? -1e3 : 1e3) * lump.radius_m)));
    }
    m_lumpsNear->setValue(lumps[0]);
    m_lumpsFar->setValue(lumps[1]);
}

void PalpationContent::showMap(const SceneState& state) {
    const auto& overlay = state.overlay.of<PalpationOverlay>();
    m_card->show(state, m_mapShown);
    if (!m_mapShown || (m_mapPainted && m_mapStep == overlay.mapStep && m_mapKind == overlay.mapKind))
        return;
    m_mapPainted = true;
    m_mapStep = overlay.mapStep;
    m_mapKind = overlay.mapKind;
    const QImage picture = mapPicture(*overlay.map, m_setup, overlay.mapKind);
    m_map->change(picture.size(), [picture](QPainter& painter) {
        painter.setCompositionMode(QPainter::CompositionMode_Source);
        painter.drawImage(0, 0, picture);
    });
}

void PalpationContent::showFingers(const SceneState& state) {
    const bool several = m_parameters.tools() > 1;
    for (std::size_t i = 0; i < m_fingers.size(); ++i) {
        const ToolView& tool = state.tool[i];
        if (!tool.present || !m_setup.cues.tool) {
            m_fingers[i]->hide();
            continue;
        }
        const core::Vec3 at = drawnTip(tool);
        const Finger::Look look{several ? static_cast<int>(i) + 1 : 0,
                                several && state.activeTool == static_cast<int>(i),
                                gloveOpacity(m_setup, state, m_surface, i)};
        m_fingers[i]->show(tool, fingerLean(state, i, m_surface.normalAt(at.head<2>())), look);
    }
    m_ghost->show(state.ghost);
}

} // namespace chiron::scene3d
