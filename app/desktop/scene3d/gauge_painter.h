// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <QCoreApplication>
#include <QRectF>
#include <algorithm>
#include <cmath>

class QFont;
class QPainter;

namespace chiron::scene3d {

/// What a bar measures.
struct GaugeDial {
    QString title;          ///< with its unit
    double range_N = 6.0;   ///< the scale's end, > 0
    double limit_N = 0.0;   ///< a line with its number; 0: none
    double bandLow_N = 0.0; ///< the target; none where `bandHigh_N` is 0
    double bandHigh_N = 0.0;

    bool operator==(const GaugeDial&) const = default;
};

/// A second bar beside the force on the tools, of what an exercise measures besides.
struct SecondBar {
    GaugeDial dial;
    bool shown = false; ///< the level lets it be seen now
    double value_N = 0.0;
};

/// The end of a scale that leaves room above `most_N`, in halves of a newton.
inline double endOfScale_N(double most_N) { return std::max(1.0, std::ceil(2.0 * most_N) / 2.0); }

/// The translation context of what stands at the bars.
struct GaugeTexts {
    Q_DECLARE_TR_FUNCTIONS(chiron::scene3d::ForceGauge)
};

/// Paints frame, scale, limit line, band and words of a force bar; its hollow stays empty, and what fills it lies
/// under this. In a face of kWidth × kHeight logical pixels at scale 1, from the upper left corner.
class GaugePainter {
public:
    GaugePainter(const SceneSetup& setup, const GaugeDial& dial) : m_setup(setup), m_dial(dial) {}

    void paint(QPainter& painter) const;
    static QRectF hollow();

    static constexpr double kWidth = 76.0;
    static constexpr double kHeight = 300.0;
    static constexpr double kRange = 1.5; ///< of the limit: the force scale's end

private:
    double heightOf(double force_N) const; ///< y
    void paintScale(QPainter& painter) const;
    void paintLimit(QPainter& painter) const;
    void paintBand(QPainter& painter) const;
    QFont font(double size, bool bold) const;

    SceneSetup m_setup;
    GaugeDial m_dial;
};

/// The bar of the force on the tools, with the level's limit.
GaugeDial forceDial(const SceneSetup& setup);
/// The largest force of all tools, N: the limit holds for each.
double largestForce_N(const SceneState& state);

} // namespace chiron::scene3d
