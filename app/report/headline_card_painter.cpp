// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/headline_card_painter.h"

#include "report/report_text.h"
#include "report/text_box.h"

#include <algorithm>
#include <cmath>
#include <qcustomplot.h>

namespace chiron::report {

namespace {

// Maps a value to a position on the card's scale.
struct Scale {
    double low = 0.0;
    double high = 1.0;
    double left = 0.0;
    double width = 1.0;
    double at(double value) const {
        return left + width * std::clamp((value - low) / (high - low), 0.0, 1.0);
    }
};

Scale scaleFor(const MetricRow& row, const QRectF& bar) {
    double low = 0.0; // the scale includes zero
    double high = 0.0;
    for (const auto& value : {row.value, row.bandLow, row.bandHigh, row.gateMinimum, row.gateMaximum}) {
        if (value && std::isfinite(*value)) {
            low = std::min(low, *value);
            high = std::max(high, *value);
        }
    }
    if (!(high > low))
        high = low + 1.0;
    const double margin = 0.12 * (high - low);
    return {low < 0.0 ? low - margin : low, high > 0.0 ? high + margin : high, bar.left(), bar.width()};
}

void paintScale(QCPPainter& p, const QRectF& bar, const MetricRow& row, const PlotTheme& theme) {
    const Scale scale = scaleFor(row, bar);
    p.setPen(Qt::NoPen);
    p.setBrush(theme.rule);
    p.drawRoundedRect(bar, 2, 2);
    if (row.bandLow && row.bandHigh) {
        const QRectF band(QPointF(scale.at(*row.bandLow), bar.top() - 3),
                          QPointF(scale.at(*row.bandHigh), bar.bottom() + 3));
        p.setPen(QPen(theme.good, 1.0));
        p.setBrush(theme.goodFill);
        p.drawRect(band);
    }
    p.setPen(QPen(theme.bad, 1.8));
    for (const auto& gate : {row.gateMinimum, row.gateMaximum}) {
        if (gate)
            p.drawLine(QPointF(scale.at(*gate), bar.top() - 6), QPointF(scale.at(*gate), bar.bottom() + 6));
    }
    if (!row.value || !std::isfinite(*row.value))
        return;
    const double x = scale.at(*row.value);
    p.setPen(QPen(theme.paper, 1.0));
    p.setBrush(theme.ink);
    p.drawPolygon(QPolygonF(
        {QPointF(x, bar.center().y() + 1), QPointF(x - 6, bar.top() - 10), QPointF(x + 6, bar.top() - 10)}));
}

} // namespace

void paintHeadlineCard(QCPPainter& p, const QRectF& box, const MetricRow& row, const PlotTheme& theme) {
    p.setPen(QPen(theme.rule, 1.0));
    p.setBrush(theme.panel);
    p.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
    const QRectF inner = box.adjusted(12, 9, -12, -8);
    const auto line = [&](double top, double height, const QFont& font, const QColor& ink,
                          const QString& words) {
        // Long words get a smaller font before they are elided: a pass mark without its number says nothing.
        QFont fitting = font;
        constexpr double kSmallest_px = 8.0;
        while (QFontMetricsF(fitting).horizontalAdvance(words) > inner.width() &&
               fitting.pixelSize() > kSmallest_px)
            fitting.setPixelSize(fitting.pixelSize() - 1);
        p.setFont(fitting);
        p.setPen(ink);
        const QString shown = QFontMetricsF(fitting).elidedText(words, Qt::ElideRight, inner.width());
        p.drawText(QRectF(inner.left(), inner.top() + top, inner.width(), height),
                   Qt::AlignLeft | Qt::AlignVCenter, shown);
    };
    line(0, 15, theme.font(11.5), theme.muted, row.name.isEmpty() ? row.id : row.name);
    line(16, 32, theme.font(24, true), theme.ink, formatValue(row.value, row.unit, theme.locale));
    paintScale(p, QRectF(inner.left(), inner.top() + 63, inner.width(), 6), row, theme);
    const QString gate = formatGate(row, theme.locale);
    QString verdict = gate.isEmpty() ? Words::tr("no pass mark") : Words::tr("pass mark %1").arg(gate);
    QColor ink = theme.muted;
    if (row.passed) {
        verdict = (*row.passed ? Words::tr("✓ met: %1") : Words::tr("✗ not met: %1")).arg(verdict);
        ink = *row.passed ? theme.good : theme.bad;
    }
    line(80, 15, theme.font(11, row.passed.has_value()), ink, verdict);
    const QString band = formatBand(row, theme.locale);
    if (band.isEmpty() && row.chance)
        line(96, 14, theme.font(10.5), theme.muted, chanceWords(row, theme.locale));
    if (!band.isEmpty())
        drawText(p, QRectF(inner.left(), inner.top() + 96, inner.width(), 28),
                 row.bandSource.isEmpty() ? Words::tr("Benchmark %1").arg(band)
                                          : Words::tr("Benchmark %1, %2").arg(band, row.bandSource),
                 {theme.font(10.5), theme.muted});
}

} // namespace chiron::report
