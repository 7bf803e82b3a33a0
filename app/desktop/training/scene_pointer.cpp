// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/scene_pointer.h"

#include <QCursor>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>
#include <QWindow>

namespace chiron::desktop {

namespace {
constexpr double kEdgeShare = 0.15; // nearer to an edge than this share of the scene: back to the middle
} // namespace

ScenePointer::ScenePointer(PointerControl& control, QObject& source, QWidget& area, QObject* parent)
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
    const QPoint middle = m_area->rect().center();
    m_last = middle;
    m_known = true;
    QCursor::setPos(m_area->mapToGlobal(middle));
}

bool ScenePointer::eventFilter(QObject*, QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseMove:
        moved(static_cast<QMouseEvent&>(*event));
        return m_captured;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: // two quick marks are two marks
        if (static_cast<QMouseEvent&>(*event).button() == Qt::LeftButton) {
            if (m_captured)
                emit marked();
            else
                emit captureAsked();
        }
        return true;
    case QEvent::MouseButtonRelease:
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
    if (m_known)
        m_control.drag(at - m_last, (event.buttons() & Qt::RightButton) != 0);
    m_last = at;
    m_known = true;
    const QRectF inner = QRectF(m_area->rect())
                             .adjusted(kEdgeShare * m_area->width(), kEdgeShare * m_area->height(), -kEdgeShare * m_area->width(),
                                       -kEdgeShare * m_area->height());
    if (!inner.contains(at))
        backToMiddle();
}

} // namespace chiron::desktop
