// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/scene_pointer.h"

#include <QApplication>
#include <QCursor>
#include <QLineF>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>
#include <QWindow>

namespace chiron::desktop {

namespace {
// Closer to an edge than this share of the scene, the pointer is moved back to the middle.
constexpr double kEdgeShare = 0.15;
} // namespace

ScenePointer::ScenePointer(HandControl& control, QObject& source, QWidget& area, QObject* parent)
    : QObject(parent), m_control(control), m_source(&source), m_area(&area) {
    source.installEventFilter(this);
    area.setMouseTracking(true);
}

ScenePointer::~ScenePointer() {
    release();
}

void ScenePointer::capture() {
    if (m_captured || !m_area)
        return;
    m_captured = true;
    m_known = false;
    m_onItsWay = false;
    setCursorShape(Qt::BlankCursor);
    qApp->installEventFilter(this); // because a quick movement ends before the pointer could be moved back
    if (m_area->window()->isActiveWindow() && !inner().contains(m_area->mapFromGlobal(QCursor::pos())))
        backToMiddle();
}

void ScenePointer::release() {
    if (!m_captured)
        return;
    m_captured = false;
    qApp->removeEventFilter(this);
    setCursorShape(Qt::ArrowCursor);
}

void ScenePointer::setCursorShape(Qt::CursorShape shape) {
    if (m_area)
        m_area->setCursor(shape);
    if (auto* window = qobject_cast<QWindow*>(m_source.data()))
        window->setCursor(shape);
}

QRectF ScenePointer::inner() const {
    const double x = kEdgeShare * m_area->width();
    const double y = kEdgeShare * m_area->height();
    return QRectF(m_area->rect()).marginsRemoved({x, y, x, y});
}

void ScenePointer::backToMiddle() {
    m_onItsWay = true;
    QCursor::setPos(m_area->mapToGlobal(m_area->rect().center()));
}

// The pointer is moved back from near an edge. An event from the middle is then closer to the middle than to
// the previous position, whatever the proportions of the scene: no hand covers half of that distance between
// two events.
bool ScenePointer::isArrival(QPointF at) const {
    const QPointF middle = QRectF(m_area->rect()).center();
    return m_onItsWay && QLineF(at, middle).length() < QLineF(at, m_last).length();
}

bool ScenePointer::aroundTheScene(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonRelease && m_captured)
        m_control.buttonUp(); // wherever it is released; the window receives the event, too
    const bool moves = event->type() == QEvent::MouseMove;
    const bool presses =
        event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    if ((!moves && !presses) || !m_captured || !m_area || watched != m_area->window()->windowHandle())
        return false;
    const auto& mouse = static_cast<const QMouseEvent&>(*event);
    const QPointF at = m_area->mapFromGlobal(mouse.globalPosition());
    if (QRectF(m_area->rect()).contains(at))
        return false; // belongs to the scene, which receives it next
    moves ? moved(at, mouse) : press(mouse);
    return true;
}

void ScenePointer::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton)
        return;
    if (!m_captured) {
        emit captureAsked();
        return;
    }
    m_control.buttonDown((event.modifiers() & Qt::ShiftModifier) != 0);
    emit marked();
}

bool ScenePointer::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_source)
        return aroundTheScene(watched, event);
    switch (event->type()) {
    case QEvent::MouseMove:
        moved(static_cast<QMouseEvent&>(*event).position(), static_cast<QMouseEvent&>(*event));
        return m_captured;
    case QEvent::Leave:
        if (m_captured && m_area->window()->isActiveWindow())
            backToMiddle(); // after a movement too quick for the edge
        return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: // two quick marks count as two marks
        press(static_cast<QMouseEvent&>(*event));
        return true;
    case QEvent::MouseButtonRelease:
        if (static_cast<QMouseEvent&>(*event).button() == Qt::LeftButton)
            m_control.buttonUp();
        return m_captured;
    case QEvent::ContextMenu:
        return m_captured;
    case QEvent::Wheel:
        if (m_captured)
            m_control.wheel(static_cast<QWheelEvent&>(*event).angleDelta().y());
        return true;
    default:
        return false;
    }
}

void ScenePointer::moved(QPointF at, const QMouseEvent& event) {
    if (!m_captured || !m_area)
        return;
    if (m_known && isArrival(at)) {
        m_last = QRectF(m_area->rect()).center();
        m_onItsWay = false;
    }
    if (m_known)
        m_control.drag(at - m_last, (event.buttons() & Qt::RightButton) != 0 ||
                                        (event.modifiers() & Qt::ShiftModifier) != 0);
    else if (inner().contains(at))
        m_onItsWay = false; // it arrived before the first event
    m_last = at;
    m_known = true;
    if (!m_onItsWay && !inner().contains(at))
        backToMiddle();
}

} // namespace chiron::desktop
