// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/home/level_picture.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

#include <QPointF>

namespace chiron::desktop {

/// The ball to scale (dashed if the level hides it), its dimple if it has one, and the instrument on its
/// apex.
class ApexPicture final : public LevelPicture {
public:
    ApexPicture(const simulation::SphereApexParameters& level, const PictureFrame& frame)
        : LevelPicture(frame), m_ball(level) {}
    void paint(QPainter& painter) const override;

private:
    void paintBall(QPainter& painter, QPointF centre, double radius) const;
    void paintTool(QPainter& painter, QPointF tip, double length) const;

    simulation::SphereApexParameters m_ball;
};

} // namespace chiron::desktop
