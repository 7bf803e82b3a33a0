// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/home/grasp_picture.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

namespace chiron::desktop {

/// The tube with the instruments that hold it.
class TubePicture final : public GraspPicture {
public:
    TubePicture(const simulation::ElasticTubeParameters& level, const PictureFrame& frame)
        : GraspPicture(frame), m_level(level) {}
    void paint(QPainter& painter) const override;

private:
    simulation::ElasticTubeParameters m_level;
};

} // namespace chiron::desktop
