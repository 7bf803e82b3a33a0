// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/desktop/urethra_picture.h"

#include "simulation/geometry/urethra/urethra_centreline.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

/// From the side, as in the overview: z of the anatomy to the right, y up. Thickness is exaggerated three
/// times so that it is visible.
void UrethraPicture::paint(QPainter& painter) const {
    const simulation::UrethraAnatomy& anatomy = m_level.anatomy;
    const simulation::UrethraCentreline line(anatomy);
    const simulation::UrethraWall wall(anatomy, m_level.endoscope);
    const simulation::CentrelinePoint neck = line.atZ(anatomy.zEnd_m);
    const core::Vec3 bladder = neck.p_A + anatomy.bladderRadius_m * neck.t_A;
    const double high_m = bladder.y() + anatomy.bladderRadius_m + 0.016;
    const double perMetre = height() / high_m;
    const double wide_m = bladder.z() + anatomy.bladderRadius_m;
    const double left = 0.5 * (width() - wide_m * perMetre) + 0.008 * perMetre;
    const auto at = [&](const core::Vec3& p) {
        return QPointF(left + p.z() * perMetre, height() - (p.y() + 0.010) * perMetre);
    };
    const QColor tissue = m_theme.color(Colour::seriesB);
    const Qt::PenStyle style = m_visible ? Qt::SolidLine : Qt::DashLine;
    painter.setPen(QPen(m_visible ? tissue.darker(150) : m_theme.color(Colour::text),
                        std::max(1.5, width() * 0.01), style));
    painter.setBrush(m_visible ? QBrush(tissue.lighter(140)) : QBrush(Qt::NoBrush));
    const double radius = anatomy.bladderRadius_m * perMetre;
    painter.drawEllipse(at(bladder), radius, radius);
    QPolygonF canal;
    constexpr int kSections = 48;
    for (int side : {1, -1})
        for (int i = 0; i <= kSections; ++i) {
            const double s = line.length_m() * (side > 0 ? i : kSections - i) / kSections;
            const simulation::CentrelinePoint p = line.at(s);
            canal << at(p.p_A + side * 2.2 * wall.radius_m(s) * p.n_A);
        }
    painter.setBrush(m_visible ? QBrush(tissue) : QBrush(Qt::NoBrush));
    painter.drawPolygon(canal);
    painter.setBrush(m_theme.color(Colour::text));
    painter.setPen(Qt::NoPen);
    for (const simulation::BladderLandmark& landmark : m_level.landmarks) {
        const core::Vec3 out = std::cos(landmark.polar_rad) * neck.t_A +
                               std::sin(landmark.polar_rad) * std::sin(landmark.azimuth_rad) * neck.n_A;
        painter.drawEllipse(at(bladder + 0.85 * anatomy.bladderRadius_m * out), width() * 0.012,
                            width() * 0.012);
    }
    const double thick = std::max(4.0, 2.2 * 2.0 * m_level.endoscope.radius_m * perMetre);
    const QPointF tip = at({0.0, 0.0, 0.010});
    painter.setPen(QPen(m_theme.color(Colour::borderStrong), thick, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(0.0, tip.y()), tip);
    painter.setPen(QPen(m_theme.color(Colour::surface), thick * 0.3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(0.0, tip.y() - 0.15 * thick), tip - QPointF(0.0, 0.15 * thick));
    painter.setPen(QPen(m_theme.color(Colour::sceneBackground), 2));
    painter.setBrush(m_theme.color(Colour::accent));
    painter.drawEllipse(tip, thick * 0.5, thick * 0.5);
}

} // namespace chiron::desktop
