// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "report/plot_theme.h"
#include "simulation/palpation/map_bands.h"
#include "simulation/palpation/surface_map.h"

#include <QImage>
#include <QRectF>
#include <QSize>
#include <QString>
#include <vector>

class QPainter;

namespace chiron::report {

/// The true position and size of a lump.
/// Unit: m.
/// Frame: W.
struct PalpationMapLump {
    double x_m = 0.0; ///< of the surface point above it
    double y_m = 0.0;
    double depth_m = 0.0; ///< of its centre
    double radius_m = 0.0;
    int hardness = 0;   ///< 1..5; 0: not stated
    bool found = false; ///< drawn with a solid outline; if false, dashed with a cross
};

/// A finding as it was reported.
/// Unit: m.
/// Frame: W.
struct PalpationMapFinding {
    int number = 1; ///< as displayed, from 1
    double x_m = 0.0;
    double y_m = 0.0;
    double radius_m = 0.0; ///< 0: not said
    simulation::FindingOutcome outcome = simulation::FindingOutcome::open;
    bool selected = false;
};

/// The overlay of a map.
struct PalpationMapView {
    simulation::SurfaceMapKind kind = simulation::SurfaceMapKind::coverage;
    simulation::MapBands bands;
    int regionColumns = 3; ///< regions over which detection is scored
    int regionRows = 3;
    std::vector<PalpationMapLump> lumps; ///< empty: the truth is not shown
    std::vector<PalpationMapFinding> findings;
};

/// A map of the searched surface from above, x to the right, y away from the person. Coverage or force is
/// drawn in steps of one hue that differ in lightness, so that they can be distinguished without colour.
/// Areas that were not searched are hatched, and areas over the limit are cross-hatched. The map also shows
/// the grid of the regions, the lumps to scale, the findings by number and shape, a scale bar, and a legend
/// in newtons. Uses opaque colours only, and vector graphics except for the cells.
class PalpationMapPainter {
public:
    PalpationMapPainter(const simulation::SurfaceMap& map, PalpationMapView view, PlotTheme theme);

    /// The legend is to the right of the map in a wide room, and below it otherwise.
    void paint(QPainter& painter, const QRectF& room) const;
    /// The rectangle of the search area in this room: x = half.x is at its right edge.
    QRectF plotIn(const QRectF& room) const { return layOut(room).plot; }
    /// "Coverage: 82 % searched".
    QString title() const;
    /// A description of the picture for screen readers.
    QString words() const;

private:
    /// The sign that a line of the legend shows beside its words.
    struct LegendRow {
        enum class Sign { band, lumpFound, lumpMissed, finding } sign = Sign::band;
        simulation::MapBand band = simulation::MapBand::untouched;
        simulation::FindingOutcome outcome = simulation::FindingOutcome::open;
        QString words;
    };
    struct Layout {
        QRectF plot;
        QRectF legend;
    };
    Layout layOut(const QRectF& room) const;
    QColor colourOf(simulation::MapBand band) const;
    QPointF at(const QRectF& plot, double x_m, double y_m) const;
    std::vector<LegendRow> legend() const;
    void paintCells(QPainter& painter, const QRectF& plot) const;
    void paintHatch(QPainter& painter, const QRectF& plot) const;
    void paintEdge(QPainter& painter, const QRectF& plot) const;
    void paintRegions(QPainter& painter, const QRectF& plot) const;
    void paintTruthAndSizes(QPainter& painter, const QRectF& plot) const;
    void paintLump(QPainter& painter, QPointF at, double radius, bool found) const;
    void paintFinding(QPainter& painter, QPointF at, const PalpationMapFinding& finding) const;
    void paintScale(QPainter& painter, const QRectF& plot) const;
    void paintLegend(QPainter& painter, const QRectF& room) const;
    void paintSwatch(QPainter& painter, const QRectF& box, const LegendRow& row) const;
    QSizeF legendSize() const;

    const simulation::SurfaceMap& m_map; ///< owned by the caller; read during paint()
    PalpationMapView m_view;
    PlotTheme m_theme;
};

/// The map as a picture of `size` logical pixels, with `ratio` device pixels per logical pixel.
/// Thread: GUI.
QImage palpationMapPicture(const simulation::SurfaceMap& map, const PalpationMapView& view,
                           const PlotTheme& theme, const QSize& size, double ratio = 1.0);

} // namespace chiron::report
