// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/scene_pointer.h"

#include <QCursor>
#include <QLineF>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>
#include <QWindow>

namespace chiron::desktop {

namespace {
constexpr double kEdgeShare = 0.15; // nearer to an edge than this share of the scene: back to the middle
constexpr double kJumpShare = 0.15; // no hand jumps this share of the scene between two events; a pointer that is led back does
} // namespace

ScenePointer::ScenePointer(HandControl& control, QObject& source, QWidget& area, QObject* parent)
    : QObject(parent), m_control(control), m_source(&source), m_area(&area) {
    source.installEventFilter(this);
    area.setMouseTracking(true);
}

ScenePointer::~ScenePointer() { release(); }

void ScenePointer::capture() {
    if (m_captured || !m_area)
        return;
    m_captured = true;
    m_known = false;
    m_onItsWay = false;
    setCursorShape(Qt::BlankCursor);
    if (m_area->window()->isActiveWindow())
        backToMiddle();
}

void ScenePointer::release() {
    if (!m_captured)
        return;
    m_captured = false;
    setCursorShape(Qt::ArrowCursor);
}

void ScenePointer::setCursorShape(Qt::CursorShape shape) {
    if (m_area)
        m_area->setCursor(shape);
    if (auto* window = qobject_cast<QWindow*>(m_source.data()))
        window->setCursor(shape);
}

void ScenePointer::backToMiddle() {
    m_onItsWay = true;
    QCursor::setPos(m_area->mapToGlobal(m_area->rect().center()));
}

bool ScenePointer::isArrival(QPointF at) const {
    const QPointF middle = QRectF(m_area->rect()).center();
    const double jump = QLineF(at, m_last).length();
    return m_onItsWay && jump > kJumpShare * m_area->width() && QLineF(at, middle).length() < jump;
}

bool ScenePointer::eventFilter(QObject*, QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseMove:
        moved(static_cast<QMouseEvent&>(*event));
        return m_captured;
    case QEvent::Leave:
        if (m_captured && m_area->window()->isActiveWindow())
            backToMiddle(); // a movement too quick for the edge
        return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: // two quick marks are two marks
        if (static_cast<QMouseEvent&>(*event).button() == Qt::LeftButton) {
            if (m_captured) {
                m_control.buttonDown((static_cast<QMouseEvent&>(*event).modifiers() & Qt::ShiftModifier) != 0);
                emit marked();
            } else {
                emit captureAsked();
            }
        }
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

void ScenePointer::moved(const QMouseEvent& event) {
    if (!m_captured || !m_area)
        return;
    const QPointF at = event.position();
    if (m_known && isArrival(at)) {
        m_last = QRectF(m_area->rect()).center();
        m_onItsWay = false;
    }
    if (m_known)
        m_control.drag(at - m_last, (event.buttons() & Qt::RightButton) != 0 || (event.modifiers() & Qt::ShiftModifier) != 0);
    m_last = at;
    m_known = true;
    const QMarginsF edge(kEdgeShare * m_area->width(), kEdgeShare * m_area->height(), kEdgeShare * m_area->width(),
                         kEdgeShare * m_area->height());
    if (!m_onItsWay && !QRectF(m_area->rect()).marginsRemoved(edge).contains(at))
        backToMiddle();
}

} // namespace chiron::desktop
