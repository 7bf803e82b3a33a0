// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <QRectF>

class QFont;
class QPainter;

namespace chiron::scene3d {

/// Paints frame, scale, limit line and words of the force bar; its hollow stays empty, and what fills it lies
/// under this. In a face of kWidth × kHeight logical pixels at scale 1, from the upper left corner.
class GaugePainter {
public:
    explicit GaugePainter(const SceneSetup& setup) : m_setup(setup) {}

    void paint(QPainter& painter) const;
    static QRectF hollow();

    static constexpr double kWidth = 76.0;
    static constexpr double kHeight = 300.0;
    static constexpr double kRange = 1.5; ///< of the limit: the scale's end

private:
    double heightOf(double force_N) const; ///< y
    void paintScale(QPainter& painter) const;
    void paintLimit(QPainter& painter) const;
    QFont font(double size, bool bold) const;

    SceneSetup m_setup;
};

/// The largest force of all tools, N: the limit holds for each.
double largestForce_N(const SceneState& state);

} // namespace chiron::scene3d
