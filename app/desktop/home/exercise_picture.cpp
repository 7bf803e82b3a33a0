// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/home/exercise_picture.h"

#include "simulation/geometry/urethra/urethra_centreline.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

ExercisePicture::ExercisePicture(const Theme& theme, const catalogue::ExerciseLevel& level, QSize size_px, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_size(theme.px(size_px.width()), theme.px(size_px.height())) {
    if (const auto* ball = std::get_if<simulation::SphereApexParameters>(&level.parameters))
        m_ball = *ball;
    if (const auto* urethra = std::get_if<simulation::UrethraInsertionParameters>(&level.parameters))
        m_urethra = *urethra;
    if (const auto* tube = std::get_if<simulation::ElasticTubeParameters>(&level.parameters))
        m_tube = *tube;
    if (const auto* handling = std::get_if<simulation::ObjectHandlingParameters>(&level.parameters))
        m_handling = *handling;
    if (const auto* palpation = std::get_if<simulation::PalpationParameters>(&level.parameters))
        m_palpation = *palpation;
    m_visible = std::find(level.cues.begin(), level.cues.end(), "object") != level.cues.end();
    setFixedSize(m_size);
    setAttribute(Qt::WA_TransparentForMouseEvents);
}

void ExercisePicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double radius = m_theme.radius();
    QPainterPath frame;
    frame.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
    painter.setClipPath(frame);
    painter.fillPath(frame, m_theme.color(Colour::sceneBackground));
    if (m_urethra)
        paintUrethra(painter);
    else if (m_tube)
        paintTube(painter);
    else if (m_handling)
        paintHandling(painter);
    else if (m_palpation)
        paintPalpation(painter);
    else
        paintSphereApex(painter);
    painter.setClipping(false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.color(Colour::border), 1));
    painter.drawPath(frame);
}

void ExercisePicture::paintSphereApex(QPainter& painter) const {
    // The field is 130 mm wide; the picture shows the middle 100 of them.
    const double perMetre = width() / 0.100;
    const double ball = m_ball.radius_m * perMetre;
    const QPointF centre(width() * 0.5, height() * 0.80);
    QRectF field(0, 0, width() * 1.25, height() * 0.42);
    field.moveCenter(centre + QPointF(0, height() * 0.02));
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.color(Colour::sceneField));
    painter.drawEllipse(field);
    paintBall(painter, centre, ball);
    paintTool(painter, centre - QPointF(0, ball), height() * 0.95);
}

/// From the side, as in the overview: z of the anatomy to the right, y up. Three times as thick as it is, to be seen.
void ExercisePicture::paintUrethra(QPainter& painter) const {
    const simulation::UrethraAnatomy& anatomy = m_urethra->anatomy;
    const simulation::UrethraCentreline line(anatomy);
    const simulation::UrethraWall wall(anatomy, m_urethra->endoscope);
    const simulation::CentrelinePoint neck = line.atZ(anatomy.zEnd_m);
    const core::Vec3 bladder = neck.p_A + anatomy.bladderRadius_m * neck.t_A;
    const double high_m = bladder.y() + anatomy.bladderRadius_m + 0.016;
    const double perMetre = height() / high_m;
    const double wide_m = bladder.z() + anatomy.bladderRadius_m;
    const double left = 0.5 * (width() - wide_m * perMetre) + 0.008 * perMetre;
    const auto at = [&](const core::Vec3& p) { return QPointF(left + p.z() * perMetre, height() - (p.y() + 0.010) * perMetre); };
    const QColor tissue = m_theme.color(Colour::seriesB);
    const Qt::PenStyle style = m_visible ? Qt::SolidLine : Qt::DashLine;
    painter.setPen(QPen(m_visible ? tissue.darker(150) : m_theme.color(Colour::text), std::max(1.5, width() * 0.01), style));
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
    for (const simulation::BladderLandmark& landmark : m_urethra->landmarks) {
        const core::Vec3 out = std::cos(landmark.polar_rad) * neck.t_A +
                               std::sin(landmark.polar_rad) * std::sin(landmark.azimuth_rad) * neck.n_A;
        painter.drawEllipse(at(bladder + 0.85 * anatomy.bladderRadius_m * out), width() * 0.012, width() * 0.012);
    }
    const double thick = std::max(4.0, 2.2 * 2.0 * m_urethra->endoscope.radius_m * perMetre);
    const QPointF tip = at({0.0, 0.0, 0.010});
    painter.setPen(QPen(m_theme.color(Colour::borderStrong), thick, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(0.0, tip.y()), tip);
    painter.setPen(QPen(m_theme.color(Colour::surface), thick * 0.3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(0.0, tip.y() - 0.15 * thick), tip - QPointF(0.0, 0.15 * thick));
    painter.setPen(QPen(m_theme.color(Colour::sceneBackground), 2));
    painter.setBrush(m_theme.color(Colour::accent));
    painter.drawEllipse(tip, thick * 0.5, thick * 0.5);
}

void ExercisePicture::paintBall(QPainter& painter, QPointF centre, double radius) const {
    QPainterPath dome; // a hemisphere on the field, seen a little from above
    dome.moveTo(centre.x() - radius, centre.y());
    dome.arcTo(QRectF(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius), 180, -180);
    dome.arcTo(QRectF(centre.x() - radius, centre.y() - radius * 0.22, 2 * radius, radius * 0.44), 0, -180);
    dome.closeSubpath();
    const QColor ink = m_theme.color(Colour::seriesB);
    if (!m_visible) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_theme.color(Colour::text), std::max(1.5, radius * 0.04), Qt::DashLine));
        painter.drawPath(dome);
        return;
    }
    QRadialGradient light(centre - QPointF(radius * 0.35, radius * 0.65), radius * 1.5);
    light.setColorAt(0.0, ink.lighter(165));
    light.setColorAt(0.45, ink);
    light.setColorAt(1.0, ink.darker(165));
    painter.setPen(Qt::NoPen);
    painter.setBrush(light);
    painter.drawPath(dome);
    if (m_ball.dimpleDepth_m > 0.0) {
        const double half = radius * m_ball.dimpleRadius_m / m_ball.radius_m;
        const double offset = radius * m_ball.dimpleOffset_m / m_ball.radius_m;
        const double up = std::sqrt(std::max(0.0, radius * radius - offset * offset));
        painter.setBrush(ink.darker(190));
        painter.translate(centre + QPointF(offset, -up * 0.86));
        painter.rotate(28);
        painter.drawEllipse(QPointF(0, 0), half * 0.9, half * 0.42);
        painter.resetTransform();
    }
}

void ExercisePicture::paintTool(QPainter& painter, QPointF tip, double length) const {
    const QPointF end = tip + QPointF(length * 0.62, -length * 0.78);
    const double thick = std::max(4.0, width() * 0.032);
    painter.setPen(QPen(m_theme.color(Colour::borderStrong), thick, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(tip, end);
    painter.setPen(QPen(m_theme.color(Colour::surface), thick * 0.35, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(tip + QPointF(-thick * 0.15, -thick * 0.15), end + QPointF(-thick * 0.15, -thick * 0.15));
    painter.setPen(QPen(m_theme.color(Colour::sceneBackground), 2));
    painter.setBrush(m_theme.color(Colour::accent));
    painter.drawEllipse(tip, thick * 0.75, thick * 0.75);
}

} // namespace chiron::desktop
