// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/home/grasp_picture.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"

namespace chiron::desktop {

/// The objects, their dish and a grasper.
class HandlingPicture final : public GraspPicture {
public:
    HandlingPicture(const simulation::ObjectHandlingParameters& level, const PictureFrame& frame)
        : GraspPicture(frame), m_level(level) {}
    void paint(QPainter& painter) const override;

private:
    simulation::ObjectHandlingParameters m_level;
};

} // namespace chiron::desktop
