// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene2d/flat_panel.h"
#include "desktop/scene3d/gauge_painter.h"
#include "desktop/scene3d/scene_state.h"

#include <memory>

class QPainter;

namespace chiron::scene3d {

/// What the canvas needs to know to lay out the two panels of a flat view.
struct FlatFrame {
    QRectF above_mm; ///< range in x and y that must be visible
    QRectF side_mm;  ///< range in x and z
    /// The content draws the tools and the ghost itself; otherwise the canvas draws laparoscopic instruments.
    bool ownTools = false;
};

/// Draws the scene of one kind of exercise in the two flat views.
class IFlatContent {
public:
    virtual ~IFlatContent() = default;
    /// Content that is no view from above and from the side (such as what a camera in the body sees) paints
    /// the whole area itself and returns true. Returning false makes the canvas paint the two panels below.
    virtual bool paintWhole(QPainter& painter, const QRectF& room, const SceneSetup& setup,
                            const SceneState& state) const {
        (void)painter, (void)room, (void)setup, (void)state;
        return false;
    }
    /// The text that a screen reader reads for the picture; empty for the default text (from above and from
    /// the side).
    virtual QString name() const { return {}; }
    virtual FlatFrame frame() const = 0;
    virtual void paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                       const SceneState& state) const = 0;
    /// By default only the force on the tools, with the level's limit.
    virtual ForceBars bars(const SceneSetup& setup, const SceneState&) const { return {forceDial(setup)}; }
    /// Height (z) of the ground at a position, as drawn.
    /// Unit: m.
    /// Frame: W (world).
    virtual double groundHeight_m(const SceneState& state, double x_m, double y_m) const = 0;
};

/// Each exercise adds one line to the catalogue. Returns null if the exercise is not known.
std::unique_ptr<IFlatContent> makeFlatContent(const SceneSetup& setup);

} // namespace chiron::scene3d
