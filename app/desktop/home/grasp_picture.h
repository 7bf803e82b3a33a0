// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/home/level_picture.h"

#include <QPointF>

namespace chiron::desktop {

/// Pictures of exercises with graspers, seen from the side: tube, objects and dish in true proportion.
class GraspPicture : public LevelPicture {
public:
    using LevelPicture::LevelPicture;

protected:
    static constexpr double kPictureWidth_m = 0.150;
    static constexpr double kFloorAt = 0.80; ///< of the picture's height, from the top

    void paintFloor(QPainter& painter, double y) const;
    /// Draws the shaft, from outside the picture, and the two blades down to the tip; `opening` is the
    /// distance between the blades' ends in pixels.
    void paintGrasper(QPainter& painter, QPointF tip, QPointF from, double opening) const;
};

} // namespace chiron::desktop
