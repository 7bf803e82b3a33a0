// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <cstdint>
#include <functional>

class QObject;
class QWidget;

namespace chiron::scene3d {

/// A scene on the screen. The widget belongs to its Qt parent. Destroying the view destroys the widget; a
/// view whose widget was destroyed by its parent is safe to call and does nothing.
/// Thread: GUI.
class ISceneView {
public:
    ISceneView() = default;
    ISceneView(const ISceneView&) = delete;
    ISceneView& operator=(const ISceneView&) = delete;
    virtual ~ISceneView() = default;

    /// The widget to put into a layout. In 3D it holds a native window: no other widget may lie above it.
    virtual QWidget* widget() = 0;
    /// The object that receives mouse, wheel and key events over the scene: the native window in 3D, the
    /// widget in 2D. Install an event filter on it. Positions in these events are in the coordinates of
    /// `widget()`.
    virtual QObject* inputSource() = 0;
    /// Draws this state with the next frame. It is cheap and called up to 60 times per second. Nothing is
    /// drawn between calls.
    virtual void show(const SceneState& state) = 0;
    /// Changes colours, cues, limit or scale without loading anything again (after a change of theme,
    /// language or level).
    virtual void change(const SceneSetup& setup) = 0;
    /// The number of frames drawn so far, for the frame rate.
    virtual std::uint64_t framesDrawn() const = 0;
    /// `call` runs once, on the GUI thread, after the first complete frame (immediately, from the event loop,
    /// if that frame has already been drawn).
    virtual void onFirstFrame(std::function<void()> call) = 0;
};

} // namespace chiron::scene3d
