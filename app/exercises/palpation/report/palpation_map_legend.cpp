// SPDX-License-Identifier: GPL-3.0-or-later
// Title, description, scale bar and legend of the maps of a palpation.
#include "app/exercises/palpation/report/palpation_map_painter.h"
#include "report/report_text.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::report {

using simulation::FindingOutcome;
using simulation::MapBand;
using simulation::SurfaceMapKind;

namespace {
constexpr double kRow = 26.0; // logical pixels at scale 1
constexpr double kSign = 34.0;
} // namespace

QString PalpationMapPainter::title() const {
    if (m_view.kind == SurfaceMapKind::force)
        return Words::tr("Largest force at each place");
    return Words::tr("Coverage: %1 % searched")
        .arg(m_theme.locale.toString(static_cast<int>(100.0 * m_map.coverage())));
}

QString PalpationMapPainter::words() const {
    QStringList said{title()};
    if (!m_view.lumps.empty()) {
        const auto found = std::count_if(m_view.lumps.begin(), m_view.lumps.end(),
                                         [](const auto& lump) { return lump.found; });
        said << Words::tr("Lumps found: %1 of %2").arg(found).arg(m_view.lumps.size());
    }
    said << Words::tr("Findings reported: %1").arg(m_view.findings.size());
    const auto wrong = std::count_if(m_view.findings.begin(), m_view.findings.end(), [](const auto& finding) {
        return finding.outcome == FindingOutcome::falseAlarm;
    });
    if (wrong > 0)
        said << Words::tr("False alarms: %1").arg(wrong);
    return said.join(QStringLiteral(". ")) + QLatin1Char('.');
}

std::vector<PalpationMapPainter::LegendRow> PalpationMapPainter::legend() const {
    using Sign = LegendRow::Sign;
    std::vector<LegendRow> rows;
    const simulation::MapBands& b = m_view.bands;
    const auto number = [this](double force_N) { return m_theme.locale.toString(force_N, 'f', 1); };
    const auto band = [&rows](MapBand step, const QString& words) {
        rows.push_back({Sign::band, step, FindingOutcome::open, words});
    };
    band(MapBand::untouched, Words::tr("not touched"));
    band(MapBand::light, Words::tr("under %1 N: not searched").arg(number(b.cover_N)));
    if (m_view.kind == SurfaceMapKind::coverage) {
        band(MapBand::inBand, Words::tr("%1 N or more: searched").arg(number(b.cover_N)));
    } else {
        if (b.low_N > b.cover_N)
            band(MapBand::gentle,
                 Words::tr("%1 to %2 N: below the band").arg(number(b.cover_N), number(b.low_N)));
        band(
            MapBand::inBand,
            Words::tr("%1 to %2 N: in the band").arg(number(std::max(b.cover_N, b.low_N)), number(b.high_N)));
        band(MapBand::hard, Words::tr("%1 to %2 N: above the band").arg(number(b.high_N), number(b.limit_N)));
        band(MapBand::over, Words::tr("over %1 N: too hard").arg(number(b.limit_N)));
    }
    const auto anyLump = [this](bool found) {
        return std::any_of(m_view.lumps.begin(), m_view.lumps.end(),
                           [found](const auto& lump) { return lump.found == found; });
    };
    if (anyLump(true))
        rows.push_back({Sign::lumpFound, {}, {}, Words::tr("lump, found (to scale)")});
    if (anyLump(false))
        rows.push_back({Sign::lumpMissed, {}, {}, Words::tr("lump, missed (to scale)")});
    for (const auto& [outcome, words] : {std::pair{FindingOutcome::open, Words::tr("finding")},
                                         {FindingOutcome::hit, Words::tr("finding: hit")},
                                         {FindingOutcome::falseAlarm, Words::tr("finding: false alarm")}})
        if (std::any_of(m_view.findings.begin(), m_view.findings.end(),
                        [o = outcome](const auto& finding) { return finding.outcome == o; }))
            rows.push_back({Sign::finding, {}, outcome, words});
    return rows;
}

QSizeF PalpationMapPainter::legendSize() const {
    const QFontMetricsF metrics(m_theme.font(12));
    double wide = 0.0;
    const std::vector<LegendRow> rows = legend();
    for (const LegendRow& row : rows)
        wide = std::max(wide, metrics.horizontalAdvance(row.words));
    return {wide + (kSign + 4.0) * m_theme.scale, kRow * m_theme.scale * double(rows.size())};
}

void PalpationMapPainter::paintSwatch(QPainter& painter, const QRectF& box, const LegendRow& row) const {
    const double u = m_theme.scale;
    const QPointF middle = box.center();
    if (row.sign == LegendRow::Sign::lumpFound || row.sign == LegendRow::Sign::lumpMissed)
        return paintLump(painter, middle, 8.5 * u, row.sign == LegendRow::Sign::lumpFound);
    if (row.sign == LegendRow::Sign::finding) {
        PalpationMapFinding finding;
        finding.outcome = row.outcome;
        painter.save();
        painter.translate(middle);
        painter.scale(0.85, 0.85);
        paintFinding(painter, {0, 0}, finding);
        painter.restore();
        return;
    }
    painter.save();
    painter.setClipRect(box);
    painter.fillRect(box, colourOf(row.band));
    const bool over = row.band == MapBand::over;
    if (over || !simulation::isSearched(row.band)) {
        painter.setPen(QPen(over ? m_theme.paper : m_theme.muted, (over ? 1.6 : 0.8) * u));
        for (double x = box.left() - box.height(); x < box.right(); x += 7.0 * u)
            painter.drawLine(QPointF(x, over ? box.top() : box.bottom()),
                             QPointF(x + box.height(), over ? box.bottom() : box.top()));
    }
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.ink, u));
    painter.drawRect(box);
}

void PalpationMapPainter::paintLegend(QPainter& painter, const QRectF& room) const {
    const double u = m_theme.scale;
    double top = room.top();
    for (const LegendRow& row : legend()) {
        const QRectF box(room.left() + 2.0 * u, top + 4.0 * u, 26.0 * u, (kRow - 8.0) * u);
        paintSwatch(painter, box, row);
        painter.setPen(m_theme.ink);
        painter.setFont(m_theme.font(12));
        painter.drawText(
            QRectF(room.left() + kSign * u, top, std::max(1.0, room.width() - kSign * u), kRow * u),
            Qt::AlignLeft | Qt::AlignVCenter, row.words);
        top += kRow * u;
    }
}

/// Draws a bar of 10 or 20 mm under the map, and the side at which the person stood.
void PalpationMapPainter::paintScale(QPainter& painter, const QRectF& plot) const {
    const double u = m_theme.scale;
    const double perMm = 0.5 * plot.width() / (m_map.half_m().x() * 1e3);
    double bar_mm = 10.0;
    while (bar_mm * perMm < 0.18 * plot.width())
        bar_mm += 10.0;
    const double y = plot.bottom() + 11.0 * u;
    const double left = plot.left();
    painter.setPen(QPen(m_theme.ink, 2.0 * u, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(left, y), QPointF(left + bar_mm * perMm, y));
    for (const double x : {left, left + bar_mm * perMm})
        painter.drawLine(QPointF(x, y - 4.0 * u), QPointF(x, y + 4.0 * u));
    painter.setFont(m_theme.font(12));
    painter.drawText(QRectF(left + bar_mm * perMm + 6.0 * u, y - 10.0 * u, plot.width(), 20.0 * u),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     Words::tr("%1 mm").arg(m_theme.locale.toString(bar_mm, 'f', 0)));
    const QString near = Words::tr("near side");
    if (QFontMetricsF(painter.font()).horizontalAdvance(near) < 0.45 * plot.width()) {
        painter.setPen(m_theme.muted);
        painter.drawText(QRectF(left, y - 10.0 * u, plot.width(), 20.0 * u),
                         Qt::AlignRight | Qt::AlignVCenter, near);
    }
}

} // namespace chiron::report
