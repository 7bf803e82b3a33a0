// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/map_card.h"

#include <QPainter>
#include <QVariant>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kMargin = 12.0;
constexpr double kMostHigh = 0.45; // largest height, as a fraction of the picture's

TriangleMesh unitSquare() {
    TriangleMesh mesh;
    for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}})
        mesh.vertices.push_back({{x, y, 0.0F}, {0.0F, 0.0F, 1.0F}, {x, y}, 1.0F});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

} // namespace

MapCard::MapCard(SharedLight& light, Qt3DCore::QNode* parent)
    : QEntity(parent), m_face(new PaintedFace(this)),
      m_spot(new Qt3DRender::QParameter(QStringLiteral("spot"), QVector4D(), this)) {
    auto* face =
        new Qt3DRender::QParameter(QStringLiteral("face"), QVariant::fromValue(m_face->texture()), this);
    new Part(unitSquare(),
             light.effects.material("gauge.vert", "face.frag", {m_spot, face}, Blend::premultiplied, this),
             this);
    setEnabled(false);
}

void MapCard::change(const SceneSetup& setup) {
    m_setup = setup;
    m_legend.reset();
}

void MapCard::setPicture(const QSize& size_px, double ratio) {
    m_picture_px = size_px;
    m_ratio = ratio;
    repaint();
}

void MapCard::show(const SceneState& state, bool shown) {
    setEnabled(shown);
    if (!shown)
        return;
    const MapLegend legend = MapLegend::of(m_setup, state);
    if (m_legend && *m_legend == legend)
        return;
    m_legend.emplace(legend);
    repaint();
}

void MapCard::repaint() {
    if (!m_legend)
        return;
    const double wide = std::max(1, m_picture_px.width());
    const double high = std::max(1, m_picture_px.height());
    const QSizeF size = m_legend->size();
    const double unit = std::max(0.2, std::min(m_setup.scale * m_ratio, kMostHigh * high / size.height()));
    const QSize size_px(int(std::ceil(size.width() * unit)), int(std::ceil(size.height() * unit)));
    m_face->change(size_px, [legend = *m_legend, unit](QPainter& painter) {
        painter.scale(unit, unit);
        legend.paint(painter);
    });
    const double margin = kMargin * m_ratio;
    m_spot->setValue(QVector4D(float(-1.0 + 2.0 * margin / wide), float(-1.0 + 2.0 * margin / high),
                               float(2.0 * size_px.width() / wide), float(2.0 * size_px.height() / high)));
}

} // namespace chiron::scene3d
