// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/force_gauge.h"

#include "desktop/scene3d/plugin/gauge_face.h"

#include <Qt3DRender/QTexture>
#include <algorithm>

namespace chiron::scene3d {

namespace {

TriangleMesh unitSquare() {
    TriangleMesh mesh;
    for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}})
        mesh.vertices.push_back({{x, y, 0.0F}, {0.0F, 0.0F, 1.0F}, {x, y}, 1.0F});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

} // namespace

ForceGauge::ForceGauge(SharedLight& light, Side side, Qt3DCore::QNode* parent)
    : QEntity(parent), m_side(side) {
    const auto parameter = [this](const char* name, const QVariant& value) {
        return new Qt3DRender::QParameter(QLatin1String(name), value, this);
    };
    auto* texture = new Qt3DRender::QTexture2D(this);
    texture->setFormat(Qt3DRender::QAbstractTexture::RGBA8_UNorm);
    texture->setMinificationFilter(Qt3DRender::QAbstractTexture::Linear);
    texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Linear);
    m_face = new GaugeFace(texture);
    m_face->setSize(QSize(int(GaugePainter::kWidth), int(GaugePainter::kHeight)));
    texture->addTextureImage(m_face);
    m_spot = parameter("spot", QVector4D());
    m_column = parameter("column", QVector4D(0, 0, 1, 1));
    m_fill = parameter("fill", QVector4D());
    m_hollow = parameter("hollow", QVector3D());
    m_over = parameter("over", 0.0F);
    m_size = parameter("size_px", QVector2D(1, 1));
    auto* material = light.effects.material(
        "gauge.vert", "gauge.frag",
        {m_spot, m_column, m_fill, m_hollow, m_over, m_size,
         parameter("face", QVariant::fromValue<Qt3DRender::QAbstractTexture*>(texture))},
        Blend::premultiplied, this);
    new Part(unitSquare(), material, this);
}

void ForceGauge::change(const SceneSetup& setup, const GaugeDial& dial, bool shown) {
    m_setup = setup;
    m_dial = dial;
    m_shown = shown;
    place();
}

void ForceGauge::setPicture(const QSize& size_px, double ratio) {
    m_picture_px = size_px;
    m_ratio = ratio;
    place();
}

void ForceGauge::place() {
    setEnabled(m_shown);
    const double wide = std::max(1, m_picture_px.width());
    const double high = std::max(1, m_picture_px.height());
    const double margin = 12.0 * m_ratio;
    // The bar shrinks with a small picture.
    const double unit = std::min(m_setup.scale * m_ratio, (high - 2.0 * margin) / GaugePainter::kHeight);
    const double width_px = std::ceil(GaugePainter::kWidth * unit);
    const double height_px = std::ceil(GaugePainter::kHeight * unit);
    m_face->change(m_setup, m_dial, std::max(0.2, unit));
    m_widthShare = m_shown ? (width_px + margin) / wide : 0.0;
    const double left =
        m_side == Side::right ? 1.0 - 2.0 * (width_px + margin) / wide : -1.0 + 2.0 * margin / wide;
    m_spot->setValue(QVector4D(float(left), float(-height_px / high), float(2.0 * width_px / wide),
                               float(2.0 * height_px / high)));
    const QRectF hollow = GaugePainter::hollow(); // measured from the top; the shader counts from the bottom
    m_column->setValue(QVector4D(
        float(hollow.left() / GaugePainter::kWidth), float(1.0 - hollow.bottom() / GaugePainter::kHeight),
        float(hollow.width() / GaugePainter::kWidth), float(hollow.height() / GaugePainter::kHeight)));
    m_hollow->setValue(toTint(m_setup.colours.background).toVector3D());
    m_size->setValue(QVector2D(float(width_px / unit), float(height_px / unit)));
}

void ForceGauge::show(double force_N) {
    if (!m_shown)
        return;
    const bool over = m_dial.limit_N > 0.0 && force_N > m_dial.limit_N;
    m_over->setValue(over ? 1.0F : 0.0F);
    m_fill->setValue(toTint(over ? m_setup.colours.over : m_setup.colours.arrow,
                            float(std::clamp(force_N / m_dial.range_N, 0.0, 1.0))));
}

} // namespace chiron::scene3d
