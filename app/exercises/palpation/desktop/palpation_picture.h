// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/home/level_picture.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <QPointF>

namespace chiron::desktop {

/// The section through the middle of the tissue, to scale, with the fingers on it, and its lump if the level
/// shows it.
class PalpationPicture final : public LevelPicture {
public:
    PalpationPicture(const simulation::PalpationParameters& level, const PictureFrame& frame)
        : LevelPicture(frame), m_level(level) {}
    void paint(QPainter& painter) const override;

private:
    void paintFinger(QPainter& painter, QPointF tip, bool fromLeft, double perMetre) const;

    simulation::PalpationParameters m_level;
};

} // namespace chiron::desktop
