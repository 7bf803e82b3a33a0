// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <QObject>
#include <QSize>
#include <Qt3DCore/QEntity>
#include <memory>

namespace chiron::scene3d {

/// Everything that is drawn in the window: the entities and the frame graph. The engine owns it through
/// root().
class IStage {
public:
    IStage() = default;
    IStage(const IStage&) = delete;
    IStage& operator=(const IStage&) = delete;
    virtual ~IStage() = default;

    virtual Qt3DCore::QEntity* root() = 0;
    virtual void change(const SceneSetup& setup) = 0;
    virtual void show(const SceneState& state) = 0;
    /// Loads what has not been visible yet, after the first frame.
    virtual void warm() = 0;
    /// Sets the size in device pixels and the number of device pixels per logical pixel.
    virtual void setPicture(const QSize& size_px, double ratio) = 0;
};

/// Creates the stage of an exercise; null if the exercise has no drawn scene. `surface` is the window to draw
/// into.
std::unique_ptr<IStage> makeStage(const SceneSetup& setup, QObject* surface);
bool hasStage(const SceneSetup& setup);

} // namespace chiron::scene3d
