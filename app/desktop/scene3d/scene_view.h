// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <cstdint>
#include <functional>

class QObject;
class QWidget;

namespace chiron::scene3d {

/// A scene on the screen. The widget belongs to its Qt parent; destroying the view destroys the widget, and a
/// view whose widget was destroyed by its parent stays safe to call (it does nothing). GUI thread.
class ISceneView {
public:
    ISceneView() = default;
    ISceneView(const ISceneView&) = delete;
    ISceneView& operator=(const ISceneView&) = delete;
    virtual ~ISceneView() = default;

    /// What to put into a layout. In 3D it holds a native window: no other widget may lie above it.
    virtual QWidget* widget() = 0;
    /// Where mouse, wheel and key events over the scene arrive: the native window in 3D, the widget in 2D.
    /// Install an event filter on it. Positions in these events are in the coordinates of `widget()`.
    virtual QObject* inputSource() = 0;
    /// Draws this state with the next frame; cheap, called up to 60 times a second. Nothing is drawn between
    /// calls.
    virtual void show(const SceneState& state) = 0;
    /// Takes other colours, cues, limit or scale without loading anything again (theme, language or level changed).
    virtual void change(const SceneSetup& setup) = 0;
    /// Frames drawn since it was made, for the frame rate.
    virtual std::uint64_t framesDrawn() const = 0;
    /// Called once, on the GUI thread, after the first whole frame was drawn (at once from the event loop, if
    /// it was).
    virtual void onFirstFrame(std::function<void()> call) = 0;
};

} // namespace chiron::scene3d
