// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/hand_control.h"

#include <QObject>
#include <QPointer>

class QMouseEvent;
class QWidget;

namespace chiron::desktop {

/// Mouse and wheel over the scene as hand movements. While captured the pointer is hidden and kept inside the scene, so
/// that no edge ends a movement; a click marks. Free, it is an ordinary pointer and a click asks for capture.
///
/// Every pixel that the pointer moves in the window is handed on, in however many events it is told: the same path ends at the same place.
/// A movement so quick that it leaves the scene between two events is taken from the window around it. What the system does not tell is
/// lost: beyond the edge of the screen there are no pixels. How fast a tool follows is the driver's law (keyboard_mouse/README.md). GUI
/// thread.
class ScenePointer final : public QObject {
    Q_OBJECT
public:
    /// `source`: where events arrive (ISceneView::inputSource()); `area`: the widget that it fills.
    ScenePointer(HandControl& control, QObject& source, QWidget& area, QObject* parent = nullptr);
    ~ScenePointer() override;

    void capture();
    void release();
    bool captured() const noexcept { return m_captured; }

signals:
    void marked();
    void captureAsked(); ///< a click while the pointer was free

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool aroundTheScene(QObject* watched, QEvent* event); ///< in its window, while captured
    void press(const QMouseEvent& event);
    void moved(QPointF at, const QMouseEvent& event); ///< at: in the area's pixels
    void backToMiddle();
    QRectF inner() const; ///< of the area, away from its edges
    bool isArrival(QPointF at) const; ///< the pointer was led back, and this is the first event from there
    void setCursorShape(Qt::CursorShape shape);

    HandControl& m_control;
    QPointer<QObject> m_source;
    QPointer<QWidget> m_area;
    bool m_captured = false;
    bool m_known = false;   ///< m_last is a place of this capture
    bool m_onItsWay = false; ///< led back to the middle; events from before may still come, or (Wayland) it never arrives
    QPointF m_last;
};

} // namespace chiron::desktop
