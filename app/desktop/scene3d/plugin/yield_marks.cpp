// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/yield_marks.h"

#include "desktop/scene3d/parts/loft.h"

namespace chiron::scene3d {

namespace {

constexpr double kStarHalf_mm = 7.0;
constexpr double kStarThick_mm = 0.9;

TriangleMesh starBar() {
    TriangleMesh mesh;
    addTurned(mesh,
              {{-kStarHalf_mm, 0.02},
               {-kStarHalf_mm + 0.8, kStarThick_mm},
               {kStarHalf_mm - 0.8, kStarThick_mm},
               {kStarHalf_mm, 0.02}},
              0.0, 12);
    return mesh;
}

} // namespace

void YieldMarks::begin() {
    m_stars = new Qt3DCore::QEntity(m_root);
    m_stars->setObjectName(QLatin1String(kName));
    m_stars->addComponent(m_over);
    m_tint = new Qt3DRender::QParameter(QStringLiteral("tint"), toTint(m_colour), m_stars);
    m_material = m_light.effects.material("solid.vert", "signal.frag", {m_tint}, Blend::opaque, m_stars);
}

void YieldMarks::addStar() {
    auto* star = new Qt3DCore::QEntity(m_stars);
    auto* place = new Qt3DCore::QTransform(star);
    place->setRotation(QQuaternion::fromAxisAndAngle(0.0F, 1.0F, 0.0F, 45.0F)); // a cross from the front
    star->addComponent(place);
    for (const QVector3D& along : {QVector3D(0, 0, 1), QVector3D(1, 0, 0), QVector3D(0, 1, 0)})
        (new Part(starBar(), m_material, star))
            ->at()
            .setRotation(QQuaternion::rotationTo(QVector3D(0, 0, 1), along));
    m_star.emplace_back(star, place);
}

void YieldMarks::change(const SceneSetup& setup) {
    m_colour = setup.colours.over;
    if (m_tint)
        m_tint->setValue(toTint(m_colour));
}

void YieldMarks::show(const SceneState& state) {
    if (!m_stars && !state.p_WYielded.empty())
        begin();
    while (m_star.size() < state.p_WYielded.size())
        addStar();
    for (std::size_t i = 0; i < m_star.size(); ++i) {
        const bool shown = i < state.p_WYielded.size();
        m_star[i].first->setEnabled(shown);
        if (shown)
            m_star[i].second->setTranslation(toMillimetres(state.p_WYielded[i]));
    }
}

} // namespace chiron::scene3d
