// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/places_view.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {

// A camera in front of and above the places, with enough perspective to distinguish near from far, but not so
// much that one place looks larger.
constexpr double kHalfWidth_m = 0.085; // half of the visible width of W at y = 0
constexpr double kTilt = 0.55;         // scale of y when it is drawn as height
constexpr double kHorizon_m = 0.9;     // distance of the vanishing point
constexpr double kFloor = 0.62;        // height of y = 0, z = 0 as a share of the view
constexpr double kPadHeight_m = 0.006;
constexpr double kShaft_m = 0.09;
constexpr double kFootRadius_m = 0.0102; // of the foot below a tube or an object
constexpr double kBodyHeight_m = 0.014;  // of an object that can be lifted, below its ring
constexpr double kLimitShare = 0.8;      // of the force bar's height at which the limit is marked

} // namespace

PlacesView::PlacesView(const Theme& theme, const PlacesSetup& setup, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_setup(setup) {
    setMinimumSize(theme.px(160), theme.px(60)); // at 200 % the answers need the space more
    setAccessibleName(tr("Objects to explore"));
    setFocusPolicy(Qt::StrongFocus);
}

void PlacesView::show(const haptics::DisplayState& state, const Now& now) {
    m_haveTool = state.tools > 0;
    m_tool = state.tool[0];
    if (now.place != m_now.place)
        m_taken_m = m_tool.p_WProxy_m;
    m_now = now;
    update();
}

void PlacesView::setMarks(const QStringList& marks) {
    m_marks = marks;
    update();
}

double PlacesView::pixelsPerMetre(double y_m) const {
    const double base = std::min(width() / (2.0 * kHalfWidth_m), height() / 0.12);
    return base * kHorizon_m / (kHorizon_m + y_m);
}

QPointF PlacesView::project(double x_m, double y_m, double z_m) const {
    const double scale = pixelsPerMetre(y_m);
    return {0.5 * width() + x_m * scale, kFloor * height() - y_m * kTilt * scale - z_m * scale};
}

void PlacesView::paintField(QPainter& painter) const {
    painter.fillRect(rect(), m_theme.color(Colour::sceneBackground));
    QPainterPath field;
    constexpr double kX_m = 0.078;
    constexpr double kY_m = 0.034;
    field.moveTo(project(-kX_m, -kY_m, 0));
    field.lineTo(project(kX_m, -kY_m, 0));
    field.lineTo(project(kX_m, kY_m, 0));
    field.lineTo(project(-kX_m, kY_m, 0));
    field.closeSubpath();
    painter.setPen(QPen(m_theme.color(Colour::border), m_theme.px(1)));
    painter.setBrush(m_theme.color(Colour::sceneField));
    painter.drawPath(field);
}

void PlacesView::paintPad(QPainter& painter, double x_m) const {
    const double scale = pixelsPerMetre(0.0);
    const double rx = m_setup.padRadius_m * 1.25 * scale;
    const double ry = rx * kTilt;
    const QPointF top = project(x_m, 0, 0);
    const QPointF foot = top + QPointF(0, kPadHeight_m * scale);
    const QColor body = m_theme.color(Colour::accentSoft);
    QLinearGradient side(top.x() - rx, 0, top.x() + rx, 0);
    side.setColorAt(0.0, body.darker(118));
    side.setColorAt(0.4, body);
    side.setColorAt(1.0, body.darker(135));
    QPainterPath wall;
    wall.moveTo(top.x() - rx, top.y());
    wall.arcTo(QRectF(foot.x() - rx, foot.y() - ry, 2 * rx, 2 * ry), 180, 180);
    wall.lineTo(top.x() + rx, top.y());
    wall.closeSubpath();
    painter.setPen(QPen(m_theme.color(Colour::accent), m_theme.px(1)));
    painter.setBrush(side);
    painter.drawPath(wall);
    QRadialGradient face(top - QPointF(0.3 * rx, 0.3 * ry), 1.6 * rx);
    face.setColorAt(0.0, body.lighter(112));
    face.setColorAt(1.0, body.darker(108));
    painter.setBrush(face);
    painter.drawEllipse(top, rx, ry);
}

void PlacesView::paintHook(QPainter& painter, double x_m, bool held) const {
    const double scale = pixelsPerMetre(0.0);
    const double radius = m_setup.gripRadius_m * scale; // the whole drawn ring can be taken hold of
    const double footRadius = kFootRadius_m * scale;
    const QPointF foot = project(x_m, 0, 0);
    const QPointF rest = project(x_m, 0, m_setup.gripHeight_m);
    const QPointF end =
        held ? project(m_tool.p_WProxy_m[0], m_tool.p_WProxy_m[1], m_tool.p_WProxy_m[2]) : rest;
    const QColor body = m_theme.color(Colour::accentSoft);
    painter.setPen(QPen(m_theme.color(Colour::accent), m_theme.px(1)));
    painter.setBrush(body.darker(112));
    painter.drawEllipse(foot, footRadius, footRadius * kTilt);
    QPen tube(body, 1.5 * radius, Qt::SolidLine, Qt::FlatCap);
    QPen edge(m_theme.color(Colour::accent), 1.5 * radius + m_theme.px(2), Qt::SolidLine, Qt::FlatCap);
    for (const QPen& pen : {edge, tube}) {
        painter.setPen(pen);
        painter.drawLine(foot, end);
    }
    painter.setPen(QPen(m_theme.color(Colour::accent), m_theme.px(2)));
    painter.setBrush(body.lighter(108));
    painter.drawEllipse(end, radius, radius);
}

double PlacesView::drawnHeight_m(int place) const {
    return isCarried(place) ? std::max(0.0, m_now.lift_m) : 0.0;
}

/// An object that is lifted by its ring: it leaves its place on the table, with a shadow below it, and stands
/// there again once it was put down.
void PlacesView::paintObject(QPainter& painter, int place) const {
    const double home_m = (place - 0.5 * (m_setup.places - 1)) * m_setup.spacing_m;
    const bool carried = isCarried(place);
    const double x = home_m + (carried ? m_tool.p_WProxy_m[0] - m_taken_m[0] : 0.0);
    const double y = carried ? m_tool.p_WProxy_m[1] - m_taken_m[1] : 0.0;
    const double z = drawnHeight_m(place);
    const double scale = pixelsPerMetre(y);
    const double rx = kFootRadius_m * scale;
    const double ry = rx * kTilt;
    const QColor body = m_theme.color(Colour::accentSoft);
    const QPen edge(m_theme.color(Colour::accent), m_theme.px(1));
    if (z > 0.0) {
        const double home = kFootRadius_m * pixelsPerMetre(0.0);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_theme.color(Colour::borderStrong), m_theme.px(2), Qt::DashLine));
        painter.drawEllipse(project(home_m, 0, 0), home, home * kTilt);
        QColor dark = m_theme.color(Colour::text);
        dark.setAlpha(60);
        painter.setPen(Qt::NoPen);
        painter.setBrush(dark);
        painter.drawEllipse(project(x, y, 0), rx, ry);
    }
    const QPointF foot = project(x, y, z);
    const QPointF top = project(x, y, z + kBodyHeight_m);
    QPainterPath wall;
    wall.moveTo(top.x() - rx, top.y());
    wall.arcTo(QRectF(foot.x() - rx, foot.y() - ry, 2 * rx, 2 * ry), 180, 180);
    wall.lineTo(top.x() + rx, top.y());
    wall.closeSubpath();
    painter.setPen(edge);
    painter.setBrush(body.darker(118));
    painter.drawPath(wall);
    painter.setBrush(body);
    painter.drawEllipse(top, rx, ry);
    const double radius = m_setup.gripRadius_m * scale; // the whole drawn ring can be taken hold of
    const QPointF ring = project(x, y, z + m_setup.gripHeight_m);
    painter.setPen(QPen(m_theme.color(Colour::accent), m_theme.px(3)));
    painter.drawLine(top, ring + QPointF(0, radius));
    painter.setPen(QPen(m_theme.color(Colour::accent), m_theme.px(2)));
    painter.setBrush(body.lighter(108));
    painter.drawEllipse(ring, radius, radius);
}

/// The line below which the tool lets go, the same at every object whatever it is made of.
void PlacesView::paintLetGo(QPainter& painter, double x_m) const {
    if (m_setup.letGoHeight_m <= 0.0)
        return;
    painter.setPen(QPen(m_theme.color(Colour::text), m_theme.px(2), Qt::DashLine));
    painter.drawLine(project(x_m - kFootRadius_m, 0, m_setup.letGoHeight_m),
                     project(x_m + kFootRadius_m, 0, m_setup.letGoHeight_m));
}

/// One font for all places, small enough for the longest name to fit between the others at large scales.
QFont PlacesView::nameFont(double width_px) const {
    QFont font = m_theme.font(TextStyle::strong);
    double widest = 1.0;
    for (const QString& name : m_setup.names)
        widest = std::max(widest, QFontMetricsF(font).horizontalAdvance(name + QStringLiteral(" ✓ ")));
    if (widest > width_px)
        font.setPixelSize(
            std::max(m_theme.px(8), static_cast<int>(QFontInfo(font).pixelSize() * width_px / widest)));
    return font;
}

void PlacesView::paintName(QPainter& painter, int place) const {
    const double x_m = (place - 0.5 * (m_setup.places - 1)) * m_setup.spacing_m;
    const QPointF at = project(x_m, -0.024, 0);
    const double w = m_setup.spacing_m * pixelsPerMetre(0.0);
    painter.setFont(nameFont(w));
    const bool touched = ((m_now.touched >> place) & 1U) != 0;
    painter.setPen(m_theme.color(m_now.place == place ? Colour::accent : Colour::text));
    const int line = painter.fontMetrics().height();
    const QString name = place < m_setup.names.size() ? m_setup.names.at(place) : QString();
    painter.drawText(QRectF(at.x() - 0.5 * w, at.y(), w, line), Qt::AlignCenter,
                     touched ? name + QStringLiteral(" ✓") : name);
    const QString mark = place < m_marks.size() ? m_marks.at(place) : QString();
    if (mark.isEmpty())
        return;
    painter.setFont(m_theme.font(TextStyle::label));
    const QRectF chip(at.x() - 0.5 * painter.fontMetrics().horizontalAdvance(mark) - m_theme.px(10),
                      at.y() + line + m_theme.px(2),
                      painter.fontMetrics().horizontalAdvance(mark) + m_theme.px(20),
                      painter.fontMetrics().height() + m_theme.px(6));
    painter.setPen(QPen(m_theme.color(Colour::accent), m_theme.px(1)));
    painter.setBrush(m_theme.color(Colour::accentSoft));
    painter.drawRoundedRect(chip, m_theme.px(8), m_theme.px(8));
    painter.setPen(m_theme.color(Colour::text));
    painter.drawText(chip, Qt::AlignCenter, mark);
}

void PlacesView::paintPlace(QPainter& painter, int place) const {
    const double x_m = (place - 0.5 * (m_setup.places - 1)) * m_setup.spacing_m;
    if (m_now.objects && m_setup.visible) {
        if (m_setup.lifted)
            paintObject(painter, place);
        else
            m_setup.hooked ? paintHook(painter, x_m, m_now.place == place) : paintPad(painter, x_m);
        paintLetGo(painter, x_m);
    } else {
        const double rx = m_setup.padRadius_m * 1.25 * pixelsPerMetre(0.0);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_theme.color(Colour::borderStrong), m_theme.px(2), Qt::DashLine));
        painter.drawEllipse(project(x_m, 0, 0), rx, rx * kTilt);
    }
    paintName(painter, place);
}

const std::array<double, 3>& PlacesView::toolAt() const {
    return m_tool.rendersForce ? m_tool.p_WT_m : m_tool.p_WProxy_m;
}

void PlacesView::paintToolShadow(QPainter& painter) const {
    if (!m_haveTool)
        return;
    const auto& p = toolAt();
    const double scale = pixelsPerMetre(p[1]);
    painter.setPen(Qt::NoPen);
    QColor dark = m_theme.color(Colour::text);
    dark.setAlpha(60);
    painter.setBrush(dark);
    painter.drawEllipse(project(p[0], p[1], 0.0), 0.004 * scale, 0.004 * scale * kTilt);
}

void PlacesView::paintTool(QPainter& painter) const {
    if (!m_haveTool)
        return;
    const auto& p = toolAt();
    const QPointF tip = project(p[0], p[1], p[2]);
    const double scale = pixelsPerMetre(p[1]);
    if (!m_setup.lifted)
        paintToolShadow(painter);
    const QPointF back = tip + QPointF(0.42 * kShaft_m * scale, -kShaft_m * scale);
    painter.setPen(QPen(m_theme.color(Colour::text), 0.0042 * scale, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(tip, back);
    painter.setPen(QPen(m_theme.color(Colour::borderStrong), 0.0022 * scale, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(tip, back);
    painter.setPen(QPen(m_theme.color(Colour::text), m_theme.px(1)));
    painter.setBrush(m_theme.color(m_now.place >= 0 ? Colour::accent : Colour::surface));
    painter.drawEllipse(tip, 0.003 * scale, 0.003 * scale);
}

void PlacesView::paintForce(QPainter& painter) const {
    // No force is felt, so a bar beside the scene shows it, with its limit and without a number of its own.
    painter.setFont(m_theme.font(TextStyle::label));
    const int line = painter.fontMetrics().height();
    const double right = width() - m_theme.px(8);
    painter.setPen(m_theme.color(Colour::text));
    painter.drawText(QRectF(0, m_theme.px(6), right, line), Qt::AlignRight | Qt::AlignVCenter, tr("Force"));
    const double top = m_theme.px(12) + line;
    const QRectF bar(width() - m_theme.px(34), top, m_theme.px(14), height() - top - m_theme.px(20));
    painter.setPen(QPen(m_theme.color(Colour::borderStrong), m_theme.px(1)));
    painter.setBrush(m_theme.color(Colour::surface));
    painter.drawRoundedRect(bar, m_theme.px(4), m_theme.px(4));
    const double share = std::clamp(kLimitShare * m_now.force_N / m_now.limit_N, 0.0, 1.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.color(share > kLimitShare ? Colour::bad : Colour::accent));
    painter.drawRoundedRect(QRectF(bar.left() + m_theme.px(2), bar.bottom() - share * bar.height(),
                                   bar.width() - m_theme.px(4), share * bar.height()),
                            m_theme.px(3), m_theme.px(3));
    const double limitY = bar.bottom() - kLimitShare * bar.height();
    painter.setPen(QPen(m_theme.color(Colour::text), m_theme.px(2)));
    painter.drawLine(QPointF(bar.left() - m_theme.px(5), limitY),
                     QPointF(bar.right() + m_theme.px(5), limitY));
    painter.setPen(m_theme.color(Colour::text));
    painter.drawText(QRectF(0, limitY - 0.5 * line, bar.left() - m_theme.px(9), line),
                     Qt::AlignRight | Qt::AlignVCenter,
                     tr("Limit: %1 N").arg(locale().toString(m_now.limit_N, 'g', 3)));
}

void PlacesView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintField(painter);
    if (m_setup.lifted) // on the table, behind the objects that stand there
        paintToolShadow(painter);
    for (int place = 0; place < m_setup.places; ++place)
        if (!isCarried(place))
            paintPlace(painter, place);
    if (isCarried(m_now.place)) // in front of those that it is carried past
        paintPlace(painter, m_now.place);
    paintTool(painter);
    if (m_now.feltNothing)
        paintForce(painter);
}

} // namespace chiron::desktop
