// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "desktop/scene3d/scene_setup.h"

#include <QFont>
#include <QPointF>
#include <QRectF>
#include <QString>

class QPaintDevice;
class QPainter;

namespace chiron::scene3d {

/// One of the two pictures: a card with a title, and a plot whose two axes have the same scale in
/// millimetres. From above: x and y; from the side: x and z; in profile: y and z.
class FlatPanel {
public:
    enum class Side { above, side, profile };

    /// `range_mm`: what the plot shows; x to the right, y upwards (so a QRectF's "top" is the lowest value).
    FlatPanel(Side side, const QRectF& range_mm, const SceneSetup& setup);

    /// The scale of words and lines at which the frame of a card takes no more than half of this height, but not under 0.7: words stay
    /// legible.
    static double scaleIn(double height, double scale);

    /// What the card needs at this scale, and what is around the plot.
    QSizeF cardSize(double pixelsPerMm) const;
    /// Shows more of the room above, so that the card is this high.
    void extendUp(double cardHeight, double pixelsPerMm);
    void place(const QPointF& corner, double pixelsPerMm);

    void paintCard(QPainter& painter, const QString& title, const QString& across, const QString& up) const;
    /// The font of a card's title: smaller where the card is too narrow for the title in its usual size. Call place() first.
    QFont titleFont(const QString& title, QPaintDevice* device) const;
    QPointF at(double across_mm, double up_mm) const;
    /// A point or vector of W (metres) in this picture.
    QPointF project(const core::Vec3& p_m) const;
    double pixels(double length_mm) const { return length_mm * m_scale; }
    Side side() const { return m_side; }
    const QRectF& plot() const { return m_plot; }
    const QRectF& range_mm() const { return m_range_mm; }
    double unit() const { return m_setup.scale; } ///< pixels of a line 1 wide
    QFont font(double size, bool bold) const;

private:
    void paintTicks(QPainter& painter) const;

    Side m_side;
    QRectF m_range_mm;
    SceneSetup m_setup;
    QRectF m_plot;
    double m_scale = 1.0;
};

} // namespace chiron::scene3d
