// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/station/lateness_chart.h"

#include <QPainter>
#include <algorithm>
#include <numeric>

namespace chiron::desktop {

LatenessChart::LatenessChart(const Theme& theme, QLocale locale, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(std::move(locale)) {
    setFont(theme.font(TextStyle::body));
    setAccessibleName(tr("Lateness of the force loop"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setBins({});
}

void LatenessChart::setBins(const session::LatenessBins& bins) {
    m_lines.clear();
    const auto total = std::accumulate(bins.counts.begin(), bins.counts.end(), std::uint64_t{0});
    const auto last = bins.kEdges_us.size();
    QStringList aloud;
    for (std::size_t i = 0; i < bins.counts.size(); ++i) {
        Line line;
        const std::int64_t edge_us = bins.kEdges_us[std::min(i, last - 1)];
        line.late = i == last || edge_us > haptics::LoopStatistics::kLate_ns / 1000;
        const QString number = m_locale.toString(static_cast<qlonglong>(edge_us));
        line.range = i == last ? tr("over %1 µs").arg(number) : tr("up to %1 µs").arg(number);
        line.fraction = total > 0 ? static_cast<double>(bins.counts[i]) / static_cast<double>(total) : 0.0;
        const QString percent = m_locale.toString(line.fraction * 100.0, 'f', 2);
        line.share =
            line.late && bins.counts[i] > 0 ? tr("%1 %, late").arg(percent) : tr("%1 %").arg(percent);
        aloud << tr("%1: %2").arg(line.range, line.share);
        m_lines.push_back(std::move(line));
    }
    setAccessibleDescription(aloud.join(QStringLiteral("; ")));
    updateGeometry();
    update();
}

int LatenessChart::widest(QString Line::*text) const {
    int width = 0;
    for (const Line& line : m_lines)
        width = std::max(width, fontMetrics().horizontalAdvance(line.*text));
    return width;
}

QSize LatenessChart::sizeHint() const {
    return {widest(&Line::range) + widest(&Line::share) + m_theme.px(120),
            static_cast<int>(m_lines.size()) * m_theme.px(24)};
}

QSize LatenessChart::minimumSizeHint() const {
    return {widest(&Line::range) + widest(&Line::share) + m_theme.px(60), sizeHint().height()};
}

void LatenessChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int gap = m_theme.px(10);
    const int left = widest(&Line::range) + gap;
    const int right = width() - widest(&Line::share) - gap;
    const int high = m_theme.px(24);
    int y = 0;
    for (const Line& line : m_lines) {
        painter.setPen(m_theme.color(Colour::text));
        painter.drawText(QRect(0, y, left - gap, high), Qt::AlignRight | Qt::AlignVCenter, line.range);
        painter.drawText(QRect(right + gap, y, width() - right - gap, high), Qt::AlignLeft | Qt::AlignVCenter,
                         line.share);
        const QRectF track(left, y + high * 0.2, right - left, high * 0.6);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_theme.color(Colour::grid));
        painter.drawRect(track);
        painter.setBrush(m_theme.color(line.late ? Colour::bad : Colour::seriesA));
        const double length =
            line.fraction > 0 ? std::max(track.width() * line.fraction, m_theme.px(2) * 1.0) : 0.0;
        painter.drawRect(QRectF(track.topLeft(), QSizeF(length, track.height())));
        y += high;
    }
}

} // namespace chiron::desktop
