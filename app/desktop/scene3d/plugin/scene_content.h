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

/// The content of the scene that is specific to one kind of exercise and lies in the opening of the drape.
/// Its entities belong to the parent entity.
class ISceneContent {
public:
    virtual ~ISceneContent() = default;
    virtual void change(const SceneSetup& setup) = 0;
    virtual void show(const SceneState& state) = 0;
    /// Makes the driver compile looks that will be needed later, so that no frame lacks the field when they
    /// appear.
    virtual void warm() = 0;
    /// Height (z) of the ground at this position as drawn, on which shadows fall.
    /// Unit: m.
    /// Frame: W (world).
    virtual double groundHeight_m(double x_m, double y_m) const = 0;
    virtual double fieldRadius_m() const = 0; ///< radius of the workspace round W's origin
    virtual double planeHeight_m() const = 0;
    virtual double roomAbove_m() const = 0; ///< height above the plane that the camera must see
    /// Whether a drape with an opening surrounds the content; otherwise the content itself fills the picture.
    virtual bool isDraped() const { return true; }
    /// Elevation of the camera above the plane.
    /// Unit: rad.
    virtual double elevation_rad() const { return kCameraElevation_rad; }
    /// Whether the content draws the tools and the ghost itself; otherwise the stage draws laparoscopic
    /// instruments.
    virtual bool drawsTools() const { return false; }
    /// The bar of the force on the tools.
    virtual GaugeDial forceBar(const SceneSetup& setup, const SceneState&) const { return forceDial(setup); }
    /// The second bar beside it; empty if there is none.
    virtual std::optional<SecondBar> secondBar(const SceneState&) const { return std::nullopt; }
    /// Sets the size of the picture in device pixels and the number of device pixels per logical pixel, for
    /// content that is laid out in the picture itself.
    virtual void setPicture(const QSize& size_px, double ratio) { (void)size_px, (void)ratio; }
    /// Puts translucent parts on this layer, which is drawn after the field.
    virtual void putTranslucent(Qt3DRender::QLayer* layer) { (void)layer; }
    /// Puts parts that lie over everything, like the arrow, on this layer.
    virtual void putOver(Qt3DRender::QLayer* layer) { (void)layer; }
};

/// Creates the content of an exercise; null if the exercise has no drawn scene. Each exercise adds one line
/// to the catalogue.
std::unique_ptr<ISceneContent> makeSceneContent(const SceneSetup& setup, SharedLight& light,
                                                Qt3DCore::QEntity* parent);

} // namespace chiron::scene3d
