// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/map_legend.h"

#include "app/exercises/palpation/scene/map_picture.h"
#include "app/exercises/palpation/scene/palpation_overlay.h"

#include <QCoreApplication>
#include <QFont>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

using simulation::MapBand;
using simulation::SurfaceMapKind;

namespace {

constexpr double kMargin = 10.0; // logical pixels at scale 1
constexpr double kRow = 22.0;
constexpr double kTitle = 24.0;
constexpr double kSwatch = 26.0;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(chiron::scene3d::MapLegend)
};

} // namespace

QColor tissueColour(TissueLook look) {
    switch (look) {
    case TissueLook::pad:
        return {232, 188, 160};
    case TissueLook::gland:
        return {214, 128, 116};
    case TissueLook::skin:
        return {230, 184, 160};
    }
    return {};
}

MapLegend::MapLegend(const SceneSetup& setup, SurfaceMapKind kind, int percent)
    : m_setup(setup), m_kind(kind), m_percent(percent) {}

MapLegend MapLegend::of(const SceneSetup& setup, const SceneState& state) {
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    const auto& overlay = state.overlay.of<PalpationOverlay>();
    double share = -1.0;
    if (overlay.map)
        share = overlay.map->coverage();
    else if (cues.coverageShown)
        share = cues.coverage;
    return {setup, overlay.mapKind, share < 0.0 ? -1 : static_cast<int>(std::lround(100.0 * share))};
}

QFont MapLegend::font(double size, bool bold) const {
    QFont font(m_setup.family);
    font.setPixelSize(static_cast<int>(size));
    font.setBold(bold);
    return font;
}

QString MapLegend::title() const {
    const QString what = m_kind == SurfaceMapKind::force ? Words::tr("Largest force") : Words::tr("Searched");
    return m_percent < 0 || m_kind == SurfaceMapKind::force
               ? what
               : QStringLiteral("%1: %2 %").arg(what, QLocale().toString(m_percent));
}

std::vector<MapLegend::Row> MapLegend::rows() const {
    const simulation::MapBands bands = mapBandsOf(m_setup);
    const auto number = [](double force_N) { return QLocale().toString(force_N, 'f', 1); };
    const auto range = [&](double low_N, double high_N) {
        return Words::tr("%1 – %2 N").arg(number(low_N), number(high_N));
    };
    std::vector<Row> rows;
    if (m_kind == SurfaceMapKind::coverage) {
        rows.push_back({MapBand::inBand, Words::tr("≥ %1 N").arg(number(bands.cover_N))});
        rows.push_back({MapBand::light, Words::tr("under %1 N").arg(number(bands.cover_N))});
    } else {
        rows.push_back({MapBand::over, Words::tr("over %1 N").arg(number(bands.limit_N))});
        rows.push_back({MapBand::hard, range(bands.high_N, bands.limit_N)});
        rows.push_back(
            {MapBand::inBand,
             Words::tr("%1 (band)").arg(range(std::max(bands.cover_N, bands.low_N), bands.high_N))});
        if (bands.low_N > bands.cover_N)
            rows.push_back({MapBand::gentle, range(bands.cover_N, bands.low_N)});
        rows.push_back({MapBand::light, Words::tr("under %1 N").arg(number(bands.cover_N))});
    }
    rows.push_back({MapBand::untouched, Words::tr("not touched")});
    return rows;
}

QSizeF MapLegend::size() const {
    const QFontMetricsF metrics(font(13, false));
    const std::vector<Row> lines = rows();
    double wide = QFontMetricsF(font(13, true)).horizontalAdvance(title());
    for (const Row& row : lines)
        wide = std::max(wide, kSwatch + 8.0 + metrics.horizontalAdvance(row.words));
    return {std::ceil(wide + 2.0 * kMargin), kTitle + kRow * double(lines.size()) + 1.4 * kMargin};
}

void MapLegend::paint(QPainter& painter) const {
    const QSizeF whole = size();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor card = m_setup.colours.background;
    card.setAlphaF(m_setup.colours.highContrast ? 1.0F : 0.86F);
    painter.setPen(m_setup.colours.highContrast ? QPen(m_setup.colours.ink, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(card);
    painter.drawRoundedRect(QRectF(1, 1, whole.width() - 2, whole.height() - 2), 8, 8);
    painter.setPen(m_setup.colours.ink);
    painter.setFont(font(13, true));
    painter.drawText(QRectF(kMargin, 0.5 * kMargin, whole.width(), kTitle), Qt::AlignLeft | Qt::AlignVCenter,
                     title());
    double top = 0.6 * kMargin + kTitle;
    for (const Row& row : rows()) {
        paintSwatch(painter, QRectF(kMargin, top + 3.0, kSwatch, kRow - 6.0), row.band);
        painter.setPen(m_setup.colours.ink);
        painter.setFont(font(13, false));
        painter.drawText(QRectF(kMargin + kSwatch + 8.0, top, whole.width(), kRow),
                         Qt::AlignLeft | Qt::AlignVCenter, row.words);
        top += kRow;
    }
}

void MapLegend::paintSwatch(QPainter& painter, const QRectF& box, MapBand band) const {
    const auto* palpation = m_setup.parameters.find<simulation::PalpationParameters>();
    painter.save();
    painter.setClipRect(box);
    painter.fillRect(box, tissueColour(palpation ? tissueLookOf(palpation->tissue) : TissueLook::pad));
    painter.fillRect(box, mapColour(m_setup.colours, m_kind, band));
    const bool over = band == MapBand::over;
    if (over || !isSearched(band)) {
        painter.setPen(QPen(mapHatch(m_setup.colours, over), over ? 2.0 : 1.2));
        for (double x = box.left() - box.height(); x < box.right(); x += over ? 6.0 : 8.0)
            painter.drawLine(QPointF(x, over ? box.top() : box.bottom()),
                             QPointF(x + box.height(), over ? box.bottom() : box.top()));
    }
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_setup.colours.ink, 1.2));
    painter.drawRect(box);
}

} // namespace chiron::scene3d
