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

/// One of the two flat views: a card with a title, and a plot whose axes have the same scale in millimetres.
/// The view from above shows x and y, from the side x and z, in profile y and z.
class FlatPanel {
public:
    enum class Side { above, side, profile };

    /// `range_mm` is the range of the plot, with x to the right and y upwards (so a QRectF's "top" is the
    /// lowest value).
    FlatPanel(Side side, const QRectF& range_mm, const SceneSetup& setup);

    /// The scale of text and lines at which the frame of a card takes at most half of this height, but not
    /// below 0.7, so that text stays legible.
    static double scaleIn(double height, double scale);

    /// The size of the card at this scale, including the frame around the plot.
    QSizeF cardSize(double pixelsPerMm) const;
    /// Extends the visible range upwards so that the card has this height.
    void extendUp(double cardHeight, double pixelsPerMm);
    void place(const QPointF& corner, double pixelsPerMm);

    void paintCard(QPainter& painter, const QString& title, const QString& across, const QString& up) const;
    /// The font of a card's title: smaller where the card is too narrow for the title in its usual size. Call
    /// place() first.
    QFont titleFont(const QString& title, QPaintDevice* device) const;
    QPointF at(double across_mm, double up_mm) const;
    /// Projects a point or vector of W (in metres) into this view.
    QPointF project(const core::Vec3& p_m) const;
    double pixels(double length_mm) const { return length_mm * m_scale; }
    Side side() const { return m_side; }
    const QRectF& plot() const { return m_plot; }
    const QRectF& range_mm() const { return m_range_mm; }
    double unit() const { return m_setup.scale; } ///< width in pixels of a line of width 1
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
