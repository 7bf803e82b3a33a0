// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/live_plot.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

struct LivePlot::Frame {
    QRect area;
    double top = 1.0; ///< value at its upper edge
    int yOf(double value) const {
        return area.bottom() - qRound(std::clamp(value / top, 0.0, 1.0) * (area.height() - 1));
    }
};

namespace {

/// The next of 1, 1.5, 2, 3, 5, 7.5, 10 times a power of ten that is at least `value`.
double niceTop(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
    for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 7.5, 10.0})
        if (value <= step * decade * (1.0 + 1e-9))
            return step * decade;
    return 10.0 * decade;
}

} // namespace

LivePlot::LivePlot(const Theme& theme, const QLocale& locale, const QString& title, double top,
                   std::optional<double> limit, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale), m_title(title), m_top(top), m_limit(limit) {
    setAccessibleName(title);
    setAccessibleDescription(tr("The last %1 seconds").arg(locale.toString(kSpan_s, 'f', 0)));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_lines.reserve(ColumnTrace::kCells);
    m_over.reserve(ColumnTrace::kCells);
}

QSize LivePlot::sizeHint() const {
    return minimumSizeHint();
} // it expands to the available space
QSize LivePlot::minimumSizeHint() const {
    return {m_theme.px(160), m_theme.px(86)};
}

QString LivePlot::numberOf(double value) const {
    const bool whole = std::abs(value - std::round(value)) < 1e-9;
    return m_locale.toString(value, 'f', whole ? 0 : value < 1.0 ? 2 : 1);
}

void LivePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), m_theme.color(Colour::surface));
    const QFont font = m_theme.font(TextStyle::small);
    painter.setFont(font);
    const QFontMetrics metrics(font);
    const double highest =
        std::max({m_top, m_trace.highest() * 1.05, m_limit.value_or(0.0) * 1.25, m_high * 1.1});
    Frame frame;
    frame.top = niceTop(highest);
    int left = 0;
    for (const double share : {0.5, 1.0})
        left = std::max(left, metrics.horizontalAdvance(numberOf(share * frame.top)) + m_theme.px(8));
    frame.area = rect().adjusted(left, metrics.height() + m_theme.px(6), -m_theme.px(6),
                                 -metrics.height() - m_theme.px(4));
    if (frame.area.width() < 2 || frame.area.height() < 2)
        return;
    if (m_high > 0.0)
        paintBand(painter, frame);
    paintAxes(painter, frame);
    paintSignal(painter, frame);
    paintLimit(painter, frame);
}

void LivePlot::paintAxes(QPainter& painter, const Frame& frame) const {
    const QFontMetrics metrics(painter.font());
    painter.setPen(m_theme.color(Colour::text));
    painter.drawText(rect().adjusted(0, 0, 0, -rect().height() + metrics.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(m_title, Qt::ElideRight, width()));
    for (const double share : {0.0, 0.5, 1.0}) {
        const int y = frame.yOf(share * frame.top);
        painter.setPen(m_theme.color(Colour::grid));
        painter.drawLine(frame.area.left(), y, frame.area.right(), y);
        painter.setPen(m_theme.color(Colour::muted));
        painter.drawText(
            QRect(0, y - metrics.height() / 2, frame.area.left() - m_theme.px(5), metrics.height()),
            Qt::AlignRight | Qt::AlignVCenter, numberOf(share * frame.top));
    }
    const QRect below(frame.area.left(), frame.area.bottom() + m_theme.px(3), frame.area.width(),
                      metrics.height());
    painter.drawText(below, Qt::AlignLeft, tr("-%1 s").arg(m_locale.toString(kSpan_s, 'f', 0)));
    painter.drawText(below, Qt::AlignRight, tr("now"));
}

void LivePlot::paintBand(QPainter& painter, const Frame& frame) const {
    const int low = frame.yOf(m_low);
    const int high = frame.yOf(m_high);
    painter.fillRect(QRect(frame.area.left(), high, frame.area.width(), low - high),
                     m_theme.color(Colour::goodSoft));
    painter.setPen(QPen(m_theme.color(Colour::good), m_theme.px(1.5), Qt::DashLine));
    painter.drawLine(frame.area.left(), low, frame.area.right(), low);
    painter.drawLine(frame.area.left(), high, frame.area.right(), high);
}

void LivePlot::paintLimit(QPainter& painter, const Frame& frame) const {
    if (!m_limit)
        return;
    const int y = frame.yOf(*m_limit);
    painter.setPen(QPen(m_theme.color(Colour::bad), m_theme.px(1.5), Qt::DashLine));
    painter.drawLine(frame.area.left(), y, frame.area.right(), y);
    const QString word = tr("limit");
    const QFontMetrics metrics(painter.font());
    painter.drawText(frame.area.left() + m_theme.px(4), y - m_theme.px(3) - metrics.descent(), word);
}

void LivePlot::paintSignal(QPainter& painter, const Frame& frame) {
    const auto& columns = m_trace.columns(static_cast<std::size_t>(frame.area.width()));
    m_lines.clear();
    m_over.clear();
    const int limitY = frame.yOf(m_limit.value_or(0.0));
    const ColumnRange* before = nullptr;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const ColumnRange& now = columns[i];
        if (!now.any) {
            before = nullptr;
            continue;
        }
        // Neighbouring columns are connected: a step between two columns is drawn in the later one.
        const double lowest = before ? std::min(now.lowest, before->highest) : now.lowest;
        const double highest = before ? std::max(now.highest, before->lowest) : now.highest;
        const int x = frame.area.left() + static_cast<int>(i);
        m_lines.emplace_back(x, frame.yOf(lowest), x, frame.yOf(highest));
        if (m_limit && now.highest > *m_limit)
            m_over.emplace_back(x, limitY, x, frame.yOf(now.highest));
        before = &now;
    }
    painter.setPen(QPen(m_theme.color(Colour::overFill), 1));
    painter.drawLines(m_over.data(), static_cast<int>(m_over.size()));
    painter.setPen(QPen(m_theme.color(Colour::seriesA), m_theme.px(1.5)));
    painter.drawLines(m_lines.data(), static_cast<int>(m_lines.size()));
}

} // namespace chiron::desktop
