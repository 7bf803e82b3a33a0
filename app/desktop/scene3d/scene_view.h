// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <functional>

class QWidget;

namespace chiron::scene3d {

/// A scene on the screen. The widget belongs to its Qt parent; destroying the view destroys the widget. GUI thread.
class ISceneView {
public:
    ISceneView() = default;
    ISceneView(const ISceneView&) = delete;
    ISceneView& operator=(const ISceneView&) = delete;
    virtual ~ISceneView() = default;

    virtual QWidget* widget() = 0;
    /// Draws this state with the next frame; cheap, called up to 60 times a second.
    virtual void show(const SceneState& state) = 0;
    /// Frames drawn since it was made, for the frame rate.
    virtual std::uint64_t framesDrawn() const = 0;
    /// Called once, on the GUI thread, after the first frame was drawn.
    virtual void onFirstFrame(std::function<void()> call) = 0;
};

} // namespace chiron::scene3d
