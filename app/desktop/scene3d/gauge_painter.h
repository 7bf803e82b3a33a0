// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <QCoreApplication>
#include <QRectF>
#include <algorithm>
#include <cmath>
#include <optional>

class QFont;
class QPainter;

namespace chiron::scene3d {

/// The scale of a bar.
struct GaugeDial {
    QString title;          ///< includes the unit
    double range_N = 6.0;   ///< end of the scale, > 0
    double limit_N = 0.0;   ///< drawn as a line with its number; 0 if there is none
    double bandLow_N = 0.0; ///< the target band; none if `bandHigh_N` is 0
    double bandHigh_N = 0.0;

    bool operator==(const GaugeDial&) const = default;
};

/// A second bar beside the force on the tools, for another force that an exercise measures.
struct SecondBar {
    GaugeDial dial;
    bool shown = false; ///< the level shows it at this moment
    double value_N = 0.0;
};

/// The bars of the forces that an exercise measures.
struct ForceBars {
    GaugeDial force;                   ///< of the force on the tools
    std::optional<SecondBar> second{}; ///< beside it; empty if there is none
};

/// The end of a scale that includes `most_N`: the next multiple of 0.5 N, at least 1 N.
inline double endOfScale_N(double most_N) {
    return std::max(1.0, std::ceil(2.0 * most_N) / 2.0);
}

/// The translation context for the texts at the bars.
struct GaugeTexts {
    Q_DECLARE_TR_FUNCTIONS(chiron::scene3d::ForceGauge)
};

/// Paints the frame, scale, limit line, band and texts of a force bar. The hollow stays transparent; the
/// filling is drawn underneath. The face is width() × kHeight logical pixels at scale 1, measured from the
/// upper left corner. `text`: how much larger the texts are than usual, 1 to kLargestText, for a bar that has
/// to be smaller than the scale asks for. The face is as much wider, and has fewer numbers.
class GaugePainter {
public:
    GaugePainter(const SceneSetup& setup, const GaugeDial& dial, double text = 1.0)
        : m_setup(setup), m_dial(dial), m_text(text) {}

    void paint(QPainter& painter) const;
    static QRectF hollow();

    static constexpr double kWidth = 76.0;
    static constexpr double kHeight = 300.0;
    static constexpr double kLargestText = 1.8;
    double width() const { return kWidth * m_text; }
    static constexpr double kRange = 1.5; ///< end of the force scale, as a multiple of the limit

private:
    double heightOf(double force_N) const; ///< the y coordinate of a force
    void paintScale(QPainter& painter) const;
    void paintLimit(QPainter& painter) const;
    void paintBand(QPainter& painter) const;
    QFont font(double size, bool bold) const;

    SceneSetup m_setup;
    GaugeDial m_dial;
    double m_text;
};

/// The bar of the force on the tools, with the level's limit.
GaugeDial forceDial(const SceneSetup& setup);
/// The largest force on any tool, because the limit holds for each one.
/// Unit: N.
double largestForce_N(const SceneState& state);

} // namespace chiron::scene3d
