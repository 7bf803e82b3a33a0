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

/// A lump as it truly was. W, metres.
struct PalpationMapLump {
    double x_m = 0.0; ///< of the surface point above it
    double y_m = 0.0;
    double depth_m = 0.0; ///< of its centre
    double radius_m = 0.0;
    int hardness = 0;   ///< 1..5; 0: not told
    bool found = false; ///< drawn whole; else dashed with a cross
};

/// A finding as it was reported. W, metres.
struct PalpationMapFinding {
    int number = 1; ///< as people see it, from 1
    double x_m = 0.0;
    double y_m = 0.0;
    double radius_m = 0.0; ///< 0: not said
    simulation::FindingOutcome outcome = simulation::FindingOutcome::open;
    bool selected = false;
};

/// What is drawn over a map.
struct PalpationMapView {
    simulation::SurfaceMapKind kind = simulation::SurfaceMapKind::coverage;
    simulation::MapBands bands;
    int regionColumns = 3; ///< the units of detection
    int regionRows = 3;
    std::vector<PalpationMapLump> lumps; ///< none: the truth is not told
    std::vector<PalpationMapFinding> findings;
};

/// A map of the searched surface from above, x to the right, y away from the person: coverage or force in steps of one hue (dark
/// or light enough to be told apart without colour), hatched where not searched, cross-hatched over the limit; the regions' grid,
/// lumps to scale, findings by number and shape, a scale bar, a legend in newtons. Opaque colours only; vector but for the cells.
class PalpationMapPainter {
public:
    PalpationMapPainter(const simulation::SurfaceMap& map, PalpationMapView view, PlotTheme theme);

    /// The legend goes to the right of the map where the room is wide, below it otherwise.
    void paint(QPainter& painter, const QRectF& room) const;
    /// Where the search area itself lies in this room: half.x from the middle is its right edge.
    QRectF plotIn(const QRectF& room) const { return layOut(room).plot; }
    /// "Coverage: 82 % searched".
    QString title() const;
    /// The picture in words, for a screen reader.
    QString words() const;

private:
    /// What a line of the legend shows beside its words.
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

    const simulation::SurfaceMap& m_map; ///< the caller's; read during paint()
    PalpationMapView m_view;
    PlotTheme m_theme;
};

/// The same as a picture of `size` logical pixels, `ratio` device pixels each. GUI thread.
QImage palpationMapPicture(const simulation::SurfaceMap& map, const PalpationMapView& view, const PlotTheme& theme, const QSize& size,
                           double ratio = 1.0);

} // namespace chiron::report
