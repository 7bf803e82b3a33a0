// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/scope_picture.h"

#include "app/exercises/urethra_insertion/scene/lining_picture.h"
#include "core/units.h"
#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/parts/flat_shapes.h"
#include "desktop/scene3d/plugin/picture_texture.h"

#include <QVariant>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

// Colours of mucosa in white light, chosen by us after photographs of cystoscopies.
const QVector3D kCanalPale(0.90F, 0.56F, 0.50F);
const QVector3D kCanalRed(0.74F, 0.26F, 0.23F);
const QVector3D kBladderPale(0.93F, 0.66F, 0.56F);
const QVector3D kBladderRed(0.80F, 0.40F, 0.32F);
const QVector3D kSkinPale(0.86F, 0.60F, 0.55F);
const QVector3D kSkinRed(0.76F, 0.42F, 0.38F);
const QVector3D kBlood(0.46F, 0.05F, 0.06F);
constexpr float kNearest_mm = 0.35F;
constexpr float kFarthest_mm = 260.0F;
constexpr double kGlansSeen_m = 0.004; // arc length up to which a turned camera can see the glans
// Distance before the neck; from farther away the light does not reach it.
constexpr double kBladderSeen_m = 0.070;
// Of the lamp, so that a wall seen head-on at the metered distance is neither white nor dark.
constexpr double kGain = 0.66;

Qt3DRender::QParameter* parameter(const char* name, const QVariant& value, Qt3DCore::QNode* parent) {
    return new Qt3DRender::QParameter(QLatin1String(name), value, parent);
}

std::string nameOf(const std::vector<simulation::BladderLandmark>& landmarks) {
    std::string name = "bladder";
    for (const simulation::BladderLandmark& l : landmarks)
        name += ' ' + l.id + ' ' + std::to_string(l.polar_rad) + ' ' + std::to_string(l.azimuth_rad);
    return name;
}

} // namespace

ScopePicture::ScopePicture(const UrethraModel& model, EffectShelf& effects, EndoscopeGraph& graph,
                           Qt3DCore::QEntity* root)
    : m_model(model), m_effects(effects), m_graph(graph), m_root(root),
      m_anatomy(new Qt3DCore::QEntity(root)), m_bladder(new Qt3DCore::QEntity(m_anatomy)),
      m_glans(new Qt3DCore::QEntity(m_anatomy)),
      m_lamp(parameter("lamp", QVector4D(0.0F, -1.4F, 0.0F, 100.0F), root)),
      m_sharpness(parameter("sharpness", QVector2D(), root)), m_reach(parameter("reach", QVector2D(), root)),
      m_blurred(
          parameter("blurred", QVariant::fromValue<Qt3DRender::QAbstractTexture*>(graph.blurred()), root)) {
    const simulation::UrethraInsertionParameters& p = model.drawing().parameters();
    auto* place = new Qt3DCore::QTransform(m_anatomy);
    place->setTranslation(toMillimetres(p.pose.p_WA));
    place->setRotation(toQuaternion(p.pose.q_WA));
    m_anatomy->addComponent(place);
    m_anatomy->addComponent(graph.inside());
    auto* canal = makePictureTexture(
        "canal", QSize(512, 1024), [] { return canalPicture().bytes; }, root);
    auto* bladder = makePictureTexture(
        nameOf(p.landmarks), QSize(1024, 512),
        [landmarks = p.landmarks] { return bladderPicture(landmarks).bytes; }, root);
    model.addCanal(lining("canal.vert", canal, kCanalPale, kCanalRed, 1.5F, 0.9F, core::Vec3::UnitZ()),
                   m_anatomy);
    model.addBladder(lining("lining.vert", bladder, kBladderPale, kBladderRed, 1.2F, 0.06F,
                            -model.drawing().bladderDirection_A(0.0, 0.0)),
                     m_bladder);
    model.addGlans(lining("lining.vert", canal, kSkinPale, kSkinRed, 0.35F, 0.25F, core::Vec3::UnitZ()),
                   m_glans);
    makePasses();
    const double angle_deg = p.endoscope.fieldOfView_rad * 180.0 / core::kPi;
    graph.scope()->lens()->setPerspectiveProjection(float(angle_deg), 1.0F, kNearest_mm, kFarthest_mm);
}

Qt3DRender::QMaterial* ScopePicture::lining(const char* vertexShader, Qt3DRender::QAbstractTexture* picture,
                                            const QVector3D& pale, const QVector3D& red, float rough,
                                            float wet, const core::Vec3& axis_A) {
    const auto own = [&](const char* name, const QVariant& value) { return parameter(name, value, m_root); };
    const simulation::UrethraAnatomy& anatomy = m_model.drawing().parameters().anatomy;
    return m_effects.materialWith("#define LAMP\n", vertexShader, "lining.frag",
                                  {m_lamp, m_sharpness, m_blurred,
                                   own("skin", QVariant::fromValue<Qt3DRender::QAbstractTexture*>(picture)),
                                   own("pale", pale), own("red", red), own("blood", kBlood),
                                   own("rough", rough), own("wet", wet), own("axis", toVector(axis_A)),
                                   own("bend", QVector3D(float(2.0 * anatomy.curvature_per_m),
                                                         float(kCanalTile_mm), float(anatomy.straight_m)))},
                                  Blend::opaque, m_root);
}

void ScopePicture::makePasses() {
    auto* black =
        m_effects.material("screen.vert", "plain.frag", {parameter("tint", QVector4D(0, 0, 0, 1), m_root)},
                           Blend::opaque, m_root);
    auto* blur = m_effects.material(
        "screen.vert", "blur.frag",
        {parameter("seen", QVariant::fromValue<Qt3DRender::QAbstractTexture*>(m_graph.seen()), m_root),
         m_reach},
        Blend::opaque, m_root);
    (new Part(roundWindow(), black, m_root))->addComponent(m_graph.mask());
    (new Part(roundPicture(), blur, m_root))->addComponent(m_graph.blur());
}

void ScopePicture::change(const SceneSetup& setup) {
    m_depthOfField = setup.depthOfField;
    m_graph.setDepthOfField(m_depthOfField);
    aimLens();
}

void ScopePicture::place(int side_px) {
    m_side_px = side_px;
    aimLens();
}

void ScopePicture::aimLens() {
    const double side = std::max(2, m_side_px);
    const double largest_px = ThinLens::kLargest_px * side / 700.0;
    const double angle = m_model.drawing().parameters().endoscope.fieldOfView_rad;
    const double strength = m_depthOfField ? m_lens.strength_px_mm(side, angle) / largest_px : 0.0;
    m_sharpness->setValue(QVector2D(float(1.0 / m_metered_mm), float(strength)));
    const double small = EndoscopeGraph::kSmall;
    m_reach->setValue(QVector2D(float(0.5 * small * largest_px), float(std::floor(small * side) - 1.0)));
    m_lamp->setValue(QVector4D(0.0F, -1.4F, 0.0F, float(kGain * m_metered_mm * m_metered_mm)));
}

void ScopePicture::show(const ToolView& tool, bool shown) {
    m_anatomy->setEnabled(shown && tool.present);
    if (!tool.present)
        return;
    const UrethraDrawing& drawing = m_model.drawing();
    const core::Mat3 axes_W = drawing.parameters().pose.q_WA.toRotationMatrix() * drawing.axes_A(tool);
    const double s_m = drawing.centreline().foot(drawing.tip_A(tool)).at.s_m;
    m_glans->setEnabled(s_m < kGlansSeen_m);
    m_bladder->setEnabled(s_m > drawing.centreline().length_m() - kBladderSeen_m);
    const core::Vec3 tip = drawnTip(tool);
    Qt3DRender::QCamera& camera = *m_graph.scope();
    camera.setPosition(toMillimetres(tip));
    camera.setViewCenter(toMillimetres(tip - 0.01 * axes_W.col(2)));
    camera.setUpVector(toVector(axes_W.col(1)));
    m_metered_mm = drawing.meteredDistance_m(tool) * 1e3;
    aimLens();
}

} // namespace chiron::scene3d
