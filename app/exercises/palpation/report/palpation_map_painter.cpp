// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/report/palpation_map_painter.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace chiron::report {

using simulation::FindingOutcome;
using simulation::MapBand;
using simulation::SurfaceMap;
using simulation::SurfaceMapKind;

namespace {

constexpr double kTitle = 26.0; // logical pixels at scale 1
constexpr double kScaleRow = 26.0;
constexpr double kGap = 12.0;
constexpr double kHatchEvery = 7.0;

QColor between(const QColor& from, const QColor& to, double share) {
    const auto mix = [share](int a, int b) { return static_cast<int>(std::lround(a + share * (b - a))); };
    return {mix(from.red(), to.red()), mix(from.green(), to.green()), mix(from.blue(), to.blue())};
}

} // namespace

PalpationMapPainter::PalpationMapPainter(const SurfaceMap& map, PalpationMapView view, PlotTheme theme)
    : m_map(map), m_view(std::move(view)), m_theme(std::move(theme)) {}

/// One hue from the paper to the accent: lightness alone distinguishes the steps, in every theme and in
/// print.
QColor PalpationMapPainter::colourOf(MapBand band) const {
    if (m_view.kind == SurfaceMapKind::coverage && simulation::isSearched(band))
        return between(m_theme.paper, m_theme.accent, 0.55);
    switch (band) {
    case MapBand::untouched:
        return m_theme.paper;
    case MapBand::light:
        return between(m_theme.paper, m_theme.accent, 0.14);
    case MapBand::gentle:
        return between(m_theme.paper, m_theme.accent, 0.34);
    case MapBand::inBand:
        return between(m_theme.paper, m_theme.accent, 0.58);
    case MapBand::hard:
        return between(m_theme.paper, m_theme.accent, 0.90);
    case MapBand::over:
        return m_theme.bad;
    }
    return m_theme.paper;
}

QPointF PalpationMapPainter::at(const QRectF& plot, double x_m, double y_m) const {
    return {plot.center().x() + 0.5 * plot.width() * x_m / m_map.half_m().x(),
            plot.center().y() - 0.5 * plot.height() * y_m / m_map.half_m().y()};
}

PalpationMapPainter::Layout PalpationMapPainter::layOut(const QRectF& room) const {
    const double u = m_theme.scale;
    QRectF rest = room.adjusted(u, kTitle * u, -u, -kScaleRow * u);
    QRectF words = rest;
    const QSizeF legend = legendSize();
    const bool beside = rest.width() - legend.width() > 0.6 * rest.height();
    if (beside)
        rest.setRight(rest.right() - legend.width() - kGap * u);
    else
        rest.setBottom(rest.bottom() - legend.height() - kGap * u);
    const double perMetre =
        0.5 * std::max(1.0, std::min(rest.width() / m_map.half_m().x(), rest.height() / m_map.half_m().y()));
    const QRectF plot(rest.left(), rest.top(), 2.0 * perMetre * m_map.half_m().x(),
                      2.0 * perMetre * m_map.half_m().y());
    if (beside)
        words.setLeft(plot.right() + kGap * u);
    else
        words.setTop(plot.bottom() + (kScaleRow + 4.0) * u);
    return {plot, words};
}

void PalpationMapPainter::paint(QPainter& painter, const QRectF& room) const {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(room, m_theme.paper);
    painter.setPen(m_theme.ink);
    painter.setFont(m_theme.font(14, true));
    painter.drawText(QRectF(room.left(), room.top(), room.width(), kTitle * m_theme.scale),
                     Qt::AlignLeft | Qt::AlignVCenter, title());
    const auto [plot, legend] = layOut(room);
    paintCells(painter, plot);
    paintHatch(painter, plot);
    paintEdge(painter, plot);
    paintRegions(painter, plot);
    paintTruthAndSizes(painter, plot);
    for (const PalpationMapFinding& finding : m_view.findings)
        paintFinding(painter, at(plot, finding.x_m, finding.y_m), finding);
    paintScale(painter, plot);
    paintLegend(painter, legend);
    painter.restore();
}

void PalpationMapPainter::paintTruthAndSizes(QPainter& painter, const QRectF& plot) const {
    const double u = m_theme.scale;
    const double perMetre = 0.5 * plot.width() / m_map.half_m().x();
    painter.save();
    painter.setClipRect(plot.adjusted(-u, -u, u, u));
    for (const PalpationMapLump& lump : m_view.lumps)
        paintLump(painter, at(plot, lump.x_m, lump.y_m), perMetre * lump.radius_m, lump.found);
    painter.setBrush(Qt::NoBrush);
    for (const PalpationMapFinding& finding : m_view.findings) {
        if (!(finding.radius_m > 0.0))
            continue;
        const double radius = perMetre * finding.radius_m; // in the reported size
        const QPointF place = at(plot, finding.x_m, finding.y_m);
        painter.setPen(QPen(m_theme.paper, 3.0 * u));
        painter.drawEllipse(place, radius, radius);
        painter.setPen(QPen(m_theme.ink, 1.5 * u, Qt::DotLine));
        painter.drawEllipse(place, radius, radius);
    }
    painter.restore();
}

void PalpationMapPainter::paintCells(QPainter& painter, const QRectF& plot) const {
    QImage cells(SurfaceMap::kColumns, SurfaceMap::kRows, QImage::Format_RGB32);
    for (int row = 0; row < SurfaceMap::kRows; ++row)
        for (int column = 0; column < SurfaceMap::kColumns; ++column)
            cells.setPixelColor(column, SurfaceMap::kRows - 1 - row,
                                colourOf(m_view.bands.of(m_map.force_N(column, row))));
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.drawImage(plot, cells);
}

/// Hatches the area that was not searched, and in the other direction the area that was pressed too hard.
void PalpationMapPainter::paintHatch(QPainter& painter, const QRectF& plot) const {
    const double wide = plot.width() / SurfaceMap::kColumns;
    const double high = plot.height() / SurfaceMap::kRows;
    QPainterPath unsearched;
    QPainterPath over;
    const auto cell = [&](int row, int from, int to) {
        return QRectF(plot.left() + from * wide, plot.bottom() - (row + 1) * high, (to - from) * wide, high);
    };
    for (int row = 0; row < SurfaceMap::kRows; ++row)
        // Runs of equal cells, so that a vector page stays small.
        for (int column = 0; column < SurfaceMap::kColumns;) {
            const MapBand band = m_view.bands.of(m_map.force_N(column, row));
            const auto same = [&](int other) {
                const MapBand there = m_view.bands.of(m_map.force_N(other, row));
                return simulation::isSearched(there) == simulation::isSearched(band) &&
                       (there == MapBand::over) == (band == MapBand::over);
            };
            int end = column + 1;
            while (end < SurfaceMap::kColumns && same(end))
                ++end;
            if (!simulation::isSearched(band))
                unsearched.addRect(cell(row, column, end));
            else if (band == MapBand::over && m_view.kind == SurfaceMapKind::force)
                over.addRect(cell(row, column, end));
            column = end;
        }
    const double every = kHatchEvery * m_theme.scale;
    for (const bool up : {true, false}) {
        painter.save();
        painter.setClipPath(up ? unsearched : over);
        painter.setPen(QPen(up ? m_theme.muted : m_theme.paper, (up ? 0.8 : 1.6) * m_theme.scale));
        const double reach = plot.height();
        for (double x = plot.left() - reach; x < plot.right(); x += every)
            painter.drawLine(QPointF(x, up ? plot.bottom() : plot.top()),
                             QPointF(x + reach, up ? plot.top() : plot.bottom()));
        painter.restore();
    }
}

/// Draws the border between the searched and the unsearched area as a line along the cells.
void PalpationMapPainter::paintEdge(QPainter& painter, const QRectF& plot) const {
    const double wide = plot.width() / SurfaceMap::kColumns;
    const double high = plot.height() / SurfaceMap::kRows;
    QPainterPath edge;
    const auto searched = [&](int column, int row) {
        return simulation::isSearched(m_view.bands.of(m_map.force_N(column, row)));
    };
    const auto line = [&](double x0, double y0, double x1, double y1) {
        edge.moveTo(plot.left() + x0 * wide, plot.bottom() - y0 * high);
        edge.lineTo(plot.left() + x1 * wide, plot.bottom() - y1 * high);
    };
    for (int row = 0; row < SurfaceMap::kRows; ++row)
        for (int column = 0; column < SurfaceMap::kColumns; ++column) {
            if (column > 0 && searched(column, row) != searched(column - 1, row))
                line(column, row, column, row + 1);
            if (row > 0 && searched(column, row) != searched(column, row - 1))
                line(column, row, column + 1, row);
        }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.ink, 1.6 * m_theme.scale, Qt::SolidLine, Qt::SquareCap));
    painter.drawPath(edge);
}

void PalpationMapPainter::paintRegions(QPainter& painter, const QRectF& plot) const {
    painter.setPen(QPen(m_theme.muted, m_theme.scale, Qt::DashLine));
    for (int i = 1; i < m_view.regionColumns; ++i) {
        const double x = plot.left() + plot.width() * i / m_view.regionColumns;
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    }
    for (int i = 1; i < m_view.regionRows; ++i) {
        const double y = plot.top() + plot.height() * i / m_view.regionRows;
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.ink, 1.5 * m_theme.scale));
    painter.drawRect(plot);
}

void PalpationMapPainter::paintLump(QPainter& painter, QPointF at, double radius, bool found) const {
    const double u = m_theme.scale;
    for (const bool halo : {true, false}) {
        painter.setBrush(Qt::NoBrush);
        QPen pen(halo ? m_theme.paper : m_theme.ink, (halo ? 6.0 : 2.6) * u,
                 halo || found ? Qt::SolidLine : Qt::DashLine);
        painter.setPen(pen);
        painter.drawEllipse(at, radius, radius);
        if (found)
            continue;
        pen.setStyle(Qt::SolidLine);
        painter.setPen(pen);
        const double arm = 0.35 * radius;
        painter.drawLine(at + QPointF(-arm, -arm), at + QPointF(arm, arm));
        painter.drawLine(at + QPointF(-arm, arm), at + QPointF(arm, -arm));
    }
}

/// Draws a disc with its number. A hit has a second ring, a false alarm is a diamond, and the selected
/// finding has corner marks.
void PalpationMapPainter::paintFinding(QPainter& painter, QPointF at,
                                       const PalpationMapFinding& finding) const {
    const double u = m_theme.scale;
    const double radius = 9.0 * u;
    const bool falseAlarm = finding.outcome == FindingOutcome::falseAlarm;
    const bool hit = finding.outcome == FindingOutcome::hit;
    painter.setPen(QPen(falseAlarm ? m_theme.bad : hit ? m_theme.good : m_theme.ink, 2.2 * u));
    painter.setBrush(m_theme.paper);
    if (hit)
        painter.drawEllipse(at, radius + 4.0 * u, radius + 4.0 * u);
    if (falseAlarm) {
        const double arm = radius + 5.0 * u;
        painter.drawPolygon(QPolygonF{at + QPointF(0, -arm), at + QPointF(arm, 0), at + QPointF(0, arm),
                                      at + QPointF(-arm, 0)});
    } else {
        painter.drawEllipse(at, radius, radius);
    }
    if (finding.selected) {
        painter.setPen(QPen(m_theme.ink, 3.0 * u, Qt::SolidLine, Qt::FlatCap));
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(at + 15.0 * u * way, at + 21.0 * u * way);
    }
    painter.setPen(m_theme.ink);
    painter.setFont(m_theme.font(12, true));
    painter.drawText(QRectF(at.x() - 12.0 * u, at.y() - 12.0 * u, 24.0 * u, 24.0 * u), Qt::AlignCenter,
                     m_theme.locale.toString(finding.number));
}

QImage palpationMapPicture(const SurfaceMap& map, const PalpationMapView& view, const PlotTheme& theme,
                           const QSize& size, double ratio) {
    QImage picture(size * ratio, QImage::Format_RGB32);
    picture.setDevicePixelRatio(ratio);
    QPainter painter(&picture);
    PalpationMapPainter(map, view, theme).paint(painter, QRectF(QPointF(0, 0), QSizeF(size)));
    return picture;
}

} // namespace chiron::report
