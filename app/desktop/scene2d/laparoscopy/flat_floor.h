// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene2d/flat_content.h"

namespace chiron::scene3d {

/// Draws the floor of the abdomen (z = 0) in the flat views, and what both exercises on it have in common.
/// Unit: mm in the view.
class FlatFloor {
public:
    static QRectF rangeAbove_mm();
    static QRectF rangeSide_mm(double room_mm);
    static void paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup);
    /// Draws the place that an object is to be brought to: a dashed outline with ticks, filled in proportion
    /// to the time that the object has been held there.
    static void paintTarget(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                            const core::Vec3& p_W, double radius_m, double dwell);

    static constexpr double kReach_mm = 62.0; ///< half the width of the field
};

/// Tissue keeps its own colours in every theme.
namespace flat_tissue {
inline constexpr QColor kLight(232, 150, 138);
inline constexpr QColor kMiddle(206, 104, 98);
inline constexpr QColor kDeep(150, 62, 62);
inline constexpr QColor kEdge(104, 34, 38);
inline constexpr QColor kBlanched(244, 222, 208);
} // namespace flat_tissue

} // namespace chiron::scene3d
