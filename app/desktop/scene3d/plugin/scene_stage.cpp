// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/scene_stage.h"

#include "desktop/scene3d/camera_fit.h"
#include "desktop/scene3d/gauge_painter.h"
#include "desktop/scene3d/parts/drape_mesh.h"

#include <QMatrix4x4>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QLayerFilter>
#include <Qt3DRender/QPickingSettings>
#include <Qt3DRender/QRenderSettings>
#include <Qt3DRender/QRenderSurfaceSelector>
#include <Qt3DRender/QViewport>

namespace chiron::scene3d {

namespace {

const QColor kCavity(24, 8, 10);           // where the lamp of the laparoscope does not reach
constexpr double kOpeningBeyond_m = 0.010; // radius of the drape's opening beyond the workspace

Qt3DRender::QLayer* makeLayer(Qt3DCore::QNode* parent) {
    auto* layer = new Qt3DRender::QLayer(parent);
    layer->setRecursive(true);
    return layer;
}

} // namespace

SceneStage::SceneStage(const SceneSetup& setup, QObject* surface)
    : m_setup(setup), m_root(new Qt3DCore::QEntity), m_light(m_root),
      m_camera(new Qt3DRender::QCamera(m_root)), m_ghostLayer(makeLayer(m_root)),
      m_overLayer(makeLayer(m_root)),
      m_cloth(new Qt3DRender::QParameter(QStringLiteral("cloth"), QVector3D(), m_root)),
      m_yields(m_light, m_overLayer, m_root) {
    makeFrameGraph(surface);
    m_content = makeSceneContent(setup, m_light, m_root);
    m_content->putOn({.translucent = m_ghostLayer, .over = m_overLayer});
    m_frame = m_content->frame();
    if (m_frame.draped)
        makeDrape();
    m_marks = new PlaceMarks(m_light, m_root);
    for (Instrument*& instrument : m_instruments)
        instrument = new Instrument(m_light, false, m_root);
    m_ghost = new Instrument(m_light, true, m_root);
    m_ghost->addComponent(m_ghostLayer);
    for (ForceArrow*& arrow : m_arrows) {
        arrow = new ForceArrow(m_light, m_root);
        arrow->addComponent(m_overLayer);
    }
    m_gauge = new ForceGauge(m_light, ForceGauge::Side::right, m_root);
    m_gauge->addComponent(m_overLayer);
    m_second = new ForceGauge(m_light, ForceGauge::Side::left, m_root);
    m_second->addComponent(m_overLayer);
    m_note = new NoteCard(m_light, m_root);
    m_note->addComponent(m_overLayer);
    change(setup);
    show(SceneState{});
}

void SceneStage::makeFrameGraph(QObject* surface) {
    auto* settings = new Qt3DRender::QRenderSettings(m_root);
    auto* target = new Qt3DRender::QRenderSurfaceSelector;
    target->setSurface(surface);
    auto* viewport = new Qt3DRender::QViewport(target);
    auto* camera = new Qt3DRender::QCameraSelector(viewport);
    camera->setCamera(m_camera);

    auto* field = new Qt3DRender::QLayerFilter(camera);
    field->addLayer(m_ghostLayer);
    field->addLayer(m_overLayer);
    field->setFilterMode(Qt3DRender::QLayerFilter::DiscardAnyMatchingLayers);
    m_clear = new Qt3DRender::QClearBuffers(field);
    m_clear->setBuffers(Qt3DRender::QClearBuffers::ColorDepthBuffer);

    auto* ghost = new Qt3DRender::QLayerFilter(camera);
    ghost->addLayer(m_ghostLayer);

    auto* over = new Qt3DRender::QLayerFilter(camera);
    over->addLayer(m_overLayer);
    auto* clearDepth = new Qt3DRender::QClearBuffers(over);
    clearDepth->setBuffers(Qt3DRender::QClearBuffers::DepthBuffer);

    settings->setActiveFrameGraph(target);
    settings->setRenderPolicy(Qt3DRender::QRenderSettings::Always); // the window steps the engine itself
    m_root->addComponent(settings);
}

void SceneStage::makeDrape() {
    auto* material = m_light.effects.material("drape.vert", "drape.frag",
                                              {m_light.lamp, m_light.lens, m_light.outlined, m_cloth},
                                              Blend::opaque, m_root);
    auto* drape = new Part(drapeMesh((m_frame.fieldRadius_m + kOpeningBeyond_m) * 1e3), material, m_root);
    drape->at().setTranslation({0.0F, 0.0F, float(m_frame.planeHeight_m * 1e3)});
}

void SceneStage::change(const SceneSetup& setup) {
    m_setup = setup;
    m_light.change(setup);
    const QColor beyond = setup.colours.highContrast ? setup.colours.background : kCavity;
    m_cloth->setValue(toTint(setup.colours.field).toVector3D());
    m_content->change(setup);
    m_frame = m_content->frame();
    m_clear->setClearColor(m_frame.draped ? setup.colours.field : beyond);
    m_marks->change(setup);
    m_yields.change(setup);
    m_ghost->setGhostColour(setup.colours.ghost);
    for (ForceArrow* arrow : m_arrows)
        arrow->change(setup);
    m_forceDial = forceDial(setup);
    m_gauge->change(setup, m_forceDial, setup.cues.arrow);
    placeSecond();
    m_note->change(setup);
    aim();
}

void SceneStage::show(const SceneState& state) {
    m_content->show(state);
    m_marks->show(state, *m_content);
    m_yields.show(state);
    const bool several = toolsOf(state) > 1;
    for (std::size_t i = 0; i < state.tool.size(); ++i) {
        ToolView tool = state.tool[i];
        m_arrows[i]->show(tool);
        tool.present = tool.present && m_setup.cues.tool && !m_frame.ownTools;
        m_instruments[i]->wear(several ? static_cast<int>(i) + 1 : 0,
                               several && state.activeTool == static_cast<int>(i));
        m_instruments[i]->show(tool, entersLeft(static_cast<int>(i), several, m_setup.leftHanded));
    }
    ToolView ghost = state.ghost;
    ghost.present = ghost.present && !m_frame.ownTools;
    m_ghost->show(ghost, entersLeft(0, several, m_setup.leftHanded));
    const ForceBars bars = m_content->bars(m_setup, state);
    showForce(bars.force, state);
    showSecond(bars.second);
    m_note->show(state.note);
}

void SceneStage::showForce(const GaugeDial& dial, const SceneState& state) {
    if (!(dial == m_forceDial)) { // happens once per trial and repaints the face
        m_forceDial = dial;
        m_gauge->change(m_setup, dial, m_setup.cues.arrow);
    }
    m_gauge->show(largestForce_N(state));
}

void SceneStage::showSecond(const std::optional<SecondBar>& bar) {
    const std::optional<GaugeDial> dial = bar ? std::optional(bar->dial) : std::nullopt;
    const bool shown = bar && bar->shown;
    if (shown != m_dialShown || !(dial == m_dial)) { // this happens once per trial and repaints the face
        m_dialShown = shown;
        m_dial = dial;
        placeSecond();
        aim();
    }
    if (shown)
        m_second->show(bar->value_N);
}

void SceneStage::placeSecond() {
    m_second->change(m_setup, m_dial.value_or(GaugeDial{}), m_dialShown);
}

void SceneStage::setPicture(const QSize& size_px, double ratio) {
    m_size_px = size_px;
    m_light.setSize_px(size_px);
    m_gauge->setPicture(size_px, ratio);
    m_second->setPicture(size_px, ratio);
    m_note->setPicture(size_px, ratio);
    m_content->setPicture(size_px, ratio);
    aim();
}

void SceneStage::aim() {
    const double aspect = double(std::max(1, m_size_px.width())) / std::max(1, m_size_px.height());
    const CameraFit fit =
        fitCamera(m_frame.fieldRadius_m + 1.2 * kOpeningBeyond_m, m_frame.planeHeight_m, m_frame.roomAbove_m,
                  aspect, m_gauge->widthShare() + m_second->widthShare(), m_frame.elevation_rad);
    QMatrix4x4 projection;
    // The projection is centred in the area that the bars leave free.
    projection.translate(float(m_second->widthShare() - m_gauge->widthShare()), 0.0F);
    projection.perspective(float(fit.fieldOfView_deg), float(aspect), 20.0F, 2500.0F);
    m_camera->lens()->setProjectionMatrix(projection);
    m_camera->setPosition(toMillimetres(fit.p_WEye));
    m_camera->setViewCenter(toMillimetres(fit.p_WTarget));
    m_camera->setUpVector({0.0F, 0.0F, 1.0F});
}

} // namespace chiron::scene3d
