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

namespace chiron::scene3d {

/// How the stage sets its content in the picture.
struct ContentFrame {
    double fieldRadius_m = 0.0;                  ///< radius of the workspace round W's origin
    double planeHeight_m = 0.0;                  ///< the bottom of what is drawn
    double roomAbove_m = 0.0;                    ///< height above the plane that the camera must see
    double elevation_rad = kCameraElevation_rad; ///< of the camera above the plane
    /// A drape with an opening surrounds the content; otherwise the content itself fills the picture.
    bool draped = true;
    /// The content draws the tools and the ghost itself; otherwise the stage draws laparoscopic instruments.
    bool ownTools = false;
};

/// The layers that are drawn after the field, in this order.
struct SceneLayers {
    Qt3DRender::QLayer* translucent; ///< for translucent parts
    Qt3DRender::QLayer* over;        ///< for parts that lie over everything, like the arrow
};

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
    /// Changes only with change().
    virtual ContentFrame frame() const = 0;
    /// By default only the force on the tools, with the level's limit.
    virtual ForceBars bars(const SceneSetup& setup, const SceneState&) const { return {forceDial(setup)}; }
    /// Sets the size of the picture in device pixels and the number of device pixels per logical pixel, for
    /// content that is laid out in the picture itself.
    virtual void setPicture(const QSize& size_px, double ratio) { (void)size_px, (void)ratio; }
    /// Puts the parts that are not drawn with the field on their layers. Called once.
    virtual void putOn(const SceneLayers&) {}
};

/// Creates the content of an exercise; null if the exercise has no drawn scene. Each exercise adds one line
/// to the catalogue.
std::unique_ptr<ISceneContent> makeSceneContent(const SceneSetup& setup, SharedLight& light,
                                                Qt3DCore::QEntity* parent);

} // namespace chiron::scene3d
