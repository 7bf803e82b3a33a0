// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/home/level_picture.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

namespace chiron::desktop {

/// The urethra from the side with its strictures, the bladder with its landmarks, and the endoscope in front
/// of it.
class UrethraPicture final : public LevelPicture {
public:
    UrethraPicture(const simulation::UrethraInsertionParameters& level, const PictureFrame& frame)
        : LevelPicture(frame), m_level(level) {}
    void paint(QPainter& painter) const override;

private:
    simulation::UrethraInsertionParameters m_level;
};

} // namespace chiron::desktop
