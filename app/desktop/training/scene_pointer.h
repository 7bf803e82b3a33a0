// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/hand_control.h"

#include <QObject>
#include <QPointer>

class QMouseEvent;
class QWidget;

namespace chiron::desktop {

/// Converts mouse and wheel over the scene into hand movements. While captured, the pointer is hidden and
/// kept inside the scene, so that no edge ends a movement, and a click marks. While free it is an ordinary
/// pointer, and a click requests capture.
///
/// Every pixel that the pointer moves in the window is passed on, however many events report it: the same
/// path ends at the same place. A movement so quick that it leaves the scene between two events is taken from
/// the events of the surrounding window. Movement that the system does not report is lost: beyond the edge of
/// the screen there are no pixels. The driver decides how fast a tool follows (keyboard_mouse/README.md).
/// Thread: GUI.
class ScenePointer final : public QObject {
    Q_OBJECT
public:
    /// `source` is the object that receives the events (ISceneView::inputSource()); `area` is the widget that
    /// it fills.
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
    /// Handles events of the surrounding window while captured.
    bool aroundTheScene(QObject* watched, QEvent* event);
    void press(const QMouseEvent& event);
    void moved(QPointF at, const QMouseEvent& event); ///< `at`: in the area's pixels
    void backToMiddle();
    QRectF inner() const; ///< the area without its margins
    /// The pointer was moved back to the middle, and this is the first event from there.
    bool isArrival(QPointF at) const;
    void setCursorShape(Qt::CursorShape shape);

    HandControl& m_control;
    QPointer<QObject> m_source;
    QPointer<QWidget> m_area;
    bool m_captured = false;
    bool m_known = false; ///< m_last is valid for this capture
    /// The pointer was moved back to the middle. Earlier events may still arrive, or (on Wayland) it never
    /// gets there.
    bool m_onItsWay = false;
    QPointF m_last;
};

} // namespace chiron::desktop
