// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene2d/flat_panel.h"
#include "desktop/scene3d/gauge_painter.h"
#include "desktop/scene3d/scene_state.h"

#include <memory>
#include <optional>

class QPainter;

namespace chiron::scene3d {

/// What lies in the field, in the two flat pictures: one a kind of exercise.
class IFlatContent {
public:
    virtual ~IFlatContent() = default;
    /// Paints the whole of this room itself, and says so; false: it is painted in the two panels below.
    virtual bool paintWhole(QPainter& painter, const QRectF& room, const SceneSetup& setup, const SceneState& state) const {
        (void)painter, (void)room, (void)setup, (void)state;
        return false;
    }
    /// What a screen reader says of the picture; empty: from above and from the side.
    virtual QString name() const { return {}; }
    /// Whether the tools (and the ghost) are its own; otherwise the canvas draws laparoscopic instruments.
    virtual bool drawsTools() const { return false; }
    virtual QRectF rangeAbove_mm() const = 0; ///< x and y that must be seen
    virtual QRectF rangeSide_mm() const = 0;  ///< x and z
    virtual void paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                       const SceneState& state) const = 0;
    /// The bar of the force on the tools.
    virtual GaugeDial forceBar(const SceneSetup& setup, const SceneState&) const { return forceDial(setup); }
    /// The bar beside it; empty: there is none.
    virtual std::optional<SecondBar> secondBar(const SceneState&) const { return std::nullopt; }
    /// z of what lies under a place, as shown. Metres, W.
    virtual double groundHeight_m(const SceneState& state, double x_m, double y_m) const = 0;
};

/// One catalogue line each; empty where the exercise is not known.
std::unique_ptr<IFlatContent> makeFlatContent(const SceneSetup& setup);

} // namespace chiron::scene3d
