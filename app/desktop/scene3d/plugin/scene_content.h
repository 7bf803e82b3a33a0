// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/camera_fit.h"
#include "desktop/scene3d/gauge_painter.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <Qt3DCore/QEntity>
#include <Qt3DRender/QLayer>
#include <memory>
#include <optional>

namespace chiron::scene3d {

/// What lies in the opening of the drape: one a kind of exercise. Its entities belong to the parent entity.
class ISceneContent {
public:
    virtual ~ISceneContent() = default;
    virtual void change(const SceneSetup& setup) = 0;
    virtual void show(const SceneState& state) = 0;
    /// Has the driver compile looks that will come later, so that no frame lacks the field when they do.
    virtual void warm() = 0;
    /// z of what lies under this place, as shown: where a shadow falls. Metres, W.
    virtual double groundHeight_m(double x_m, double y_m) const = 0;
    virtual double fieldRadius_m() const = 0; ///< of the workspace round W's origin
    virtual double planeHeight_m() const = 0;
    virtual double roomAbove_m() const = 0; ///< above the plane, that the camera must see
    /// Whether a drape with an opening lies round it; otherwise its own setting fills the picture.
    virtual bool isDraped() const { return true; }
    /// Of the camera over the plane, rad.
    virtual double elevation_rad() const { return kCameraElevation_rad; }
    /// Whether the tools (and the ghost) are its own; otherwise the stage draws laparoscopic instruments.
    virtual bool drawsTools() const { return false; }
    /// The bar of the force on the tools.
    virtual GaugeDial forceBar(const SceneSetup& setup, const SceneState&) const { return forceDial(setup); }
    /// The bar beside it; empty: there is none.
    virtual std::optional<SecondBar> secondBar(const SceneState&) const { return std::nullopt; }
    /// The picture's size in device pixels, and device pixels a logical one: for what lies in the picture itself.
    virtual void setPicture(const QSize& size_px, double ratio) { (void)size_px, (void)ratio; }
    /// Translucent parts go on this layer, which is drawn after the field.
    virtual void putTranslucent(Qt3DRender::QLayer* layer) { (void)layer; }
    /// What lies over everything, as the arrow does.
    virtual void putOver(Qt3DRender::QLayer* layer) { (void)layer; }
};

/// The content of an exercise; empty where this exercise has no drawn scene. One catalogue line each.
std::unique_ptr<ISceneContent> makeSceneContent(const SceneSetup& setup, SharedLight& light,
                                                Qt3DCore::QEntity* parent);

} // namespace chiron::scene3d
