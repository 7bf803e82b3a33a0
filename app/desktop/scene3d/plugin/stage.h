// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <QObject>
#include <QSize>
#include <Qt3DCore/QEntity>
#include <memory>

namespace chiron::scene3d {

/// Everything that is drawn in the window, and how: the entities and the frame graph. Owned by the engine through root().
class IStage {
public:
    IStage() = default;
    IStage(const IStage&) = delete;
    IStage& operator=(const IStage&) = delete;
    virtual ~IStage() = default;

    virtual Qt3DCore::QEntity* root() = 0;
    virtual void change(const SceneSetup& setup) = 0;
    virtual void show(const SceneState& state) = 0;
    /// Loads what has not been seen yet, after the first frame.
    virtual void warm() = 0;
    /// Size in device pixels, and device pixels a logical one.
    virtual void setPicture(const QSize& size_px, double ratio) = 0;
};

/// The stage of an exercise; empty where it has no drawn scene. `surface`: the window drawn into.
std::unique_ptr<IStage> makeStage(const SceneSetup& setup, QObject* surface);
bool hasStage(const SceneSetup& setup);

} // namespace chiron::scene3d
