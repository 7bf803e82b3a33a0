// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene2d/flat_panel.h"
#include "desktop/scene3d/gauge_painter.h"
#include "desktop/scene3d/scene_state.h"

#include <memory>
#include <optional>

class QPainter;

namespace chiron::scene3d {

/// Draws the scene of one kind of exercise in the two flat views.
class IFlatContent {
public:
    virtual ~IFlatContent() = default;
    /// May paint the whole area itself and return true. Returning false makes the canvas paint the two panels
    /// below.
    virtual bool paintWhole(QPainter& painter, const QRectF& room, const SceneSetup& setup,
                            const SceneState& state) const {
        (void)painter, (void)room, (void)setup, (void)state;
        return false;
    }
    /// The text that a screen reader reads for the picture; empty for the default text (from above and from
    /// the side).
    virtual QString name() const { return {}; }
    /// Whether it draws the tools and the ghost itself; otherwise the canvas draws laparoscopic instruments.
    virtual bool drawsTools() const { return false; }
    virtual QRectF rangeAbove_mm() const = 0; ///< range in x and y that must be visible
    virtual QRectF rangeSide_mm() const = 0;  ///< range in x and z
    virtual void paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                       const SceneState& state) const = 0;
    /// The bar of the force on the tools.
    virtual GaugeDial forceBar(const SceneSetup& setup, const SceneState&) const { return forceDial(setup); }
    /// The second bar beside it; empty if there is none.
    virtual std::optional<SecondBar> secondBar(const SceneState&) const { return std::nullopt; }
    /// Height (z) of the ground at a position, as drawn.
    /// Unit: m.
    /// Frame: W (world).
    virtual double groundHeight_m(const SceneState& state, double x_m, double y_m) const = 0;
};

/// Each exercise adds one line to the catalogue. Returns null if the exercise is not known.
std::unique_ptr<IFlatContent> makeFlatContent(const SceneSetup& setup);

} // namespace chiron::scene3d
