// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/mouse_pictogram.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

namespace chiron::desktop {

namespace {
// Coordinates in a square of 64 by 64.
constexpr double kSide = 64.0;
const QRectF kBody(20.0, 12.0, 24.0, 40.0);
const QRectF kWheel(29.5, 18.0, 5.0, 11.0);
constexpr double kButtonEnd = 30.0; // y
constexpr double kHead = 4.5;       // size of an arrow's head
} // namespace

MousePictogram::MousePictogram(const Theme& theme, Pictogram picture, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_picture(picture) {
    setFixedSize(theme.px(kSide), theme.px(kSide));
}

void MousePictogram::paintArrow(QPainter& painter, QPointF from, QPointF to) const {
    const QPointF way = to - from;
    const QPointF along = way / std::hypot(way.x(), way.y());
    const QPointF across(-along.y(), along.x());
    painter.drawLine(from, to - along * kHead);
    painter.setBrush(painter.pen().color());
    painter.drawPolygon(QPolygonF{
        {to, to - along * kHead + across * 0.6 * kHead, to - along * kHead - across * 0.6 * kHead}});
}

void MousePictogram::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(width() / kSide, height() / kSide);
    switch (m_picture) {
    case Pictogram::moveStylus:
    case Pictogram::pressStylus:
    case Pictogram::stylusButton:
        return paintStylus(painter);
    case Pictogram::keys:
        return paintKeys(painter);
    default:
        return paintMouse(painter);
    }
}

/// Paints the handle of a haptic device: a pen whose tip touches.
void MousePictogram::paintStylus(QPainter& painter) const {
    const QColor accent = m_theme.color(Colour::accent);
    const QPointF tip(26.0, 46.0);
    const QPointF end(44.0, 10.0);
    painter.setPen(QPen(m_theme.color(Colour::text), 9.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(31.0, 36.0), end);
    painter.setPen(QPen(m_theme.color(Colour::surface), 6.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(31.0, 36.0), end);
    painter.setPen(QPen(m_theme.color(Colour::text), 2.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(30.0, 38.0), tip);
    if (m_picture == Pictogram::stylusButton) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(accent);
        painter.drawEllipse(QPointF(38.0, 22.0), 4.0, 4.0);
    }
    painter.setPen(QPen(accent, 2.0, Qt::SolidLine, Qt::RoundCap));
    if (m_picture == Pictogram::moveStylus) {
        paintArrow(painter, {18.0, 30.0}, {6.0, 30.0});
        paintArrow(painter, {48.0, 30.0}, {60.0, 30.0});
    } else if (m_picture == Pictogram::pressStylus) {
        paintArrow(painter, {14.0, 26.0}, {14.0, 44.0});
    }
    if (m_picture != Pictogram::moveStylus) {
        painter.setPen(QPen(m_theme.color(Colour::text), 1.6));
        painter.drawLine(QPointF(8.0, 54.0), QPointF(56.0, 54.0)); // the touched surface
    }
}

void MousePictogram::paintKeys(QPainter& painter) const {
    const QColor accent = m_theme.color(Colour::accent);
    for (int i = 0; i < 3; ++i) {
        painter.setPen(QPen(i == 1 ? accent : m_theme.color(Colour::text), 1.6));
        painter.setBrush(i == 1 ? accent : m_theme.color(Colour::surface));
        painter.drawRoundedRect(QRectF(5.0 + 19.0 * i, i == 1 ? 28.0 : 24.0, 16.0, 16.0), 3.0, 3.0);
    }
    painter.setPen(QPen(accent, 2.0, Qt::SolidLine, Qt::RoundCap));
    paintArrow(painter, {32.0, 8.0}, {32.0, 24.0});
}

void MousePictogram::paintMouse(QPainter& painter) const {
    QPainterPath body;
    body.addRoundedRect(kBody, 12.0, 12.0);
    const QColor accent = m_theme.color(Colour::accent);
    const bool left = m_picture == Pictogram::leftClick || m_picture == Pictogram::leftHeld;
    const bool wheel = m_picture == Pictogram::wheelTowards || m_picture == Pictogram::wheelAway;
    if (left || m_picture == Pictogram::rightHeld) {
        QPainterPath half;
        half.addRect(
            left ? QRectF(kBody.left(), kBody.top(), 0.5 * kBody.width(), kButtonEnd - kBody.top())
                 : QRectF(kBody.center().x(), kBody.top(), 0.5 * kBody.width(), kButtonEnd - kBody.top()));
        painter.fillPath(body.intersected(half), accent);
    }
    painter.setPen(QPen(m_theme.color(Colour::text), 1.6));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(body);
    painter.drawLine(QPointF(kBody.left(), kButtonEnd), QPointF(kBody.right(), kButtonEnd));
    painter.drawLine(QPointF(kBody.center().x(), kBody.top()), QPointF(kBody.center().x(), kButtonEnd));
    painter.setBrush(wheel ? accent : m_theme.color(Colour::surface));
    painter.drawRoundedRect(kWheel, 2.5, 2.5);
    painter.setPen(QPen(accent, 2.0, Qt::SolidLine, Qt::RoundCap));
    const QPointF middle = kBody.center();
    switch (m_picture) {
    case Pictogram::moveMouse:
    case Pictogram::rightHeld:
        paintArrow(painter, {17.0, middle.y()}, {5.0, middle.y()});
        paintArrow(painter, {47.0, middle.y()}, {59.0, middle.y()});
        if (m_picture == Pictogram::moveMouse) {
            paintArrow(painter, {middle.x(), 10.0}, {middle.x(), 1.0});
            paintArrow(painter, {middle.x(), 54.0}, {middle.x(), 63.0});
        }
        break;
    case Pictogram::wheelTowards: // the person sits below the picture
        paintArrow(painter, {52.0, 16.0}, {52.0, 38.0});
        break;
    case Pictogram::wheelAway:
        paintArrow(painter, {52.0, 38.0}, {52.0, 16.0});
        break;
    case Pictogram::leftClick:
        break;
    case Pictogram::leftHeld: // pressed and held
        paintArrow(painter, {13.0, 2.0}, {22.0, 11.0});
        painter.drawLine(QPointF(6.0, 58.0), QPointF(22.0, 58.0));
        break;
    default:
        break;
    }
}

} // namespace chiron::desktop
