// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/plot_view_impl.h"

#include <algorithm>
#include <cmath>

namespace chiron::report {

void DataRange::take(double value) {
    if (!std::isfinite(value))
        return;
    low = empty ? value : std::min(low, value);
    high = empty ? value : std::max(high, value);
    empty = false;
}

QCPRange DataRange::padded(const PlotAxis& axis) const {
    double from = empty ? 0.0 : low;
    double to = empty ? 1.0 : high;
    if (axis.minimum)
        from = *axis.minimum;
    if (axis.maximum)
        to = *axis.maximum;
    if (!(to - from > 1e-12 * std::max(std::abs(to), std::abs(from))) || !(to > from)) {
        const double half = std::max(0.5, 0.05 * std::abs(from));
        return {axis.minimum ? from : from - half, from + half};
    }
    const double margin = 0.05 * (to - from);
    return {axis.minimum ? from : from - margin, axis.maximum ? to : to + margin};
}

namespace {

void styleAxis(QCPAxis* axis, const PlotTheme& theme) {
    const QPen line(theme.muted, 1.0);
    axis->setBasePen(line);
    axis->setTickPen(line);
    axis->setSubTicks(false);
    axis->setTickLengthIn(0);
    axis->setTickLengthOut(4);
    axis->setTickLabelFont(theme.font(11));
    axis->setTickLabelColor(theme.ink);
    axis->setLabelFont(theme.font(11.5));
    axis->setLabelColor(theme.ink);
    axis->setLabelPadding(4);
    axis->setTickLabelPadding(4);
    axis->setNumberFormat(QStringLiteral("gb"));
    axis->grid()->setPen(QPen(theme.grid, 1.0));
    axis->grid()->setZeroLinePen(QPen(theme.rule, 1.0));
}

/// Passes wheel events on to the page that contains the plot, so that a plot does not interrupt scrolling.
class QuietPlot final : public QCustomPlot {
public:
    // QCustomPlot would otherwise keep the events that it ignores.
    explicit QuietPlot(QWidget* parent) : QCustomPlot(parent) {
        setAttribute(Qt::WA_NoMousePropagation, false);
    }

protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

} // namespace

PlotView::Impl::Impl(const PlotTheme& look, QWidget* parent) : theme(look), plot(new QuietPlot(parent)) {
    plot->setLocale(theme.locale);
    plot->setBackground(QBrush(theme.paper));
    plot->setAntialiasedElements(QCP::aeAll);
    plot->setNoAntialiasingOnDrag(true);
    for (QCPAxis* axis : {plot->xAxis, plot->yAxis})
        styleAxis(axis, theme);
    title = new QCPTextElement(plot, QString(), theme.font(13, true));
    title->setTextColor(theme.ink);
    title->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    title->setMargins(QMargins(2, 0, 0, 2));
    plot->plotLayout()->insertRow(0);
    plot->plotLayout()->insertRow(1);
    plot->plotLayout()->addElement(0, 0, title);
    plot->axisRect()->insetLayout()->take(plot->legend);
    plot->plotLayout()->addElement(1, 0, plot->legend);
    plot->plotLayout()->setRowStretchFactor(0, 0.001);
    plot->plotLayout()->setRowStretchFactor(1, 0.001);
    plot->plotLayout()->setRowSpacing(2);
    plot->plotLayout()->setMargins(QMargins(4, 4, 10, 4));
    QCPLegend* legend = plot->legend;
    legend->setVisible(true);
    legend->setFont(theme.font(11));
    legend->setTextColor(theme.ink);
    legend->setBorderPen(Qt::NoPen);
    legend->setBrush(Qt::NoBrush);
    legend->setIconSize(24, 10);
    legend->setMargins(QMargins(2, 0, 0, 2));
    legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
}

QColor PlotView::Impl::color(PlotStyle style) const {
    switch (style) {
    case PlotStyle::solidA:
        return theme.seriesA;
    case PlotStyle::dashedB:
        return theme.seriesB;
    case PlotStyle::dottedC:
        return theme.seriesC;
    case PlotStyle::longDashE:
        return theme.ink;
    case PlotStyle::dashDotD:
        break;
    }
    return theme.seriesD;
}

QPen PlotView::Impl::pen(PlotStyle style, double width) const {
    QPen pen(color(style), width);
    pen.setCapStyle(Qt::FlatCap);
    pen.setJoinStyle(Qt::RoundJoin);
    if (style == PlotStyle::dashedB)
        pen.setDashPattern({6.0, 2.5});
    if (style == PlotStyle::dottedC)
        pen.setDashPattern({1.5, 2.0});
    if (style == PlotStyle::dashDotD)
        pen.setDashPattern({6.0, 2.0, 1.5, 2.0});
    if (style == PlotStyle::longDashE)
        pen.setDashPattern({12.0, 3.0});
    return pen;
}

QCPGraph* PlotView::Impl::addGraph(const QString& name) {
    QCPGraph* graph = plot->addGraph();
    graph->setName(name);
    // fillLines() reduces the line, in the same way on every device.
    graph->setAdaptiveSampling(false);
    if (name.isEmpty())
        graph->removeFromLegend();
    return graph;
}

void PlotView::Impl::addHorizontal(const QString& name, double value, const QPen& pen) {
    auto* line = new QCPItemStraightLine(plot);
    line->setPen(pen);
    line->point1->setCoords(0.0, value);
    line->point2->setCoords(1.0, value);
    addGraph(name)->setPen(pen); // an entry for the legend
    takeY(value);
}

void PlotView::Impl::prepare(QSize size) {
    plot->xAxis->setRange(xRange.padded(xAxis));
    plot->yAxis->setRange(yRange.padded(yAxis));
    arrangeLegend(size.width());
    const QRect before = plot->viewport();
    plot->setViewport(QRect(QPoint(0, 0), size));
    // Two iterations, because the margins depend on the tick labels and the tick labels on the margins.
    for (int round = 0; round < 2; ++round) {
        plot->plotLayout()->update(QCPLayoutElement::upPreparation);
        plot->plotLayout()->update(QCPLayoutElement::upMargins);
        plot->plotLayout()->update(QCPLayoutElement::upLayout);
        if (equalScale)
            equaliseScale();
    }
    const int axisWidth = plot->axisRect()->width();
    // Plots of small height have fewer ticks, so that their numbers do not overlap.
    plot->yAxis->ticker()->setTickCount(
        std::clamp(static_cast<int>(plot->axisRect()->height() / (24.0 * theme.scale)), 2, 5));
    // Two samples per logical pixel, because pictures are written at twice the size.
    fillLines(2 * std::max(axisWidth, 50));
    placeEventLabels(axisWidth);
    plot->setViewport(before);
}

void PlotView::Impl::arrangeLegend(int width) {
    QCPLegend* legend = plot->legend;
    const QFontMetricsF metrics(legend->font());
    double widest = 1.0;
    for (int i = 0; i < legend->itemCount(); ++i) {
        if (auto* item = qobject_cast<QCPPlottableLegendItem*>(legend->item(i)))
            widest = std::max(widest, metrics.horizontalAdvance(item->plottable()->name()));
    }
    const double entry = widest + legend->iconSize().width() + legend->iconTextPadding() + 16.0;
    legend->setWrap(std::max(1, static_cast<int>((width - 20.0) / entry)));
    legend->setFillOrder(QCPLayoutGrid::foColumnsFirst, true);
}

void PlotView::Impl::fillLines(int columns) {
    const QCPRange shown = plot->xAxis->range();
    for (const Line& line : lines) {
        // The visible samples, and one more beyond either end so that the line continues to the edge.
        const std::size_t count = std::min(line.x.size(), line.y.size());
        const auto begin = line.x.begin();
        const auto end = begin + static_cast<std::ptrdiff_t>(count);
        const bool ordered = fixed() && std::is_sorted(begin, end);
        const auto after = ordered ? std::upper_bound(begin, end, shown.upper) : end;
        const auto from = ordered ? std::lower_bound(begin, end, shown.lower) : begin;
        const auto first = static_cast<std::size_t>((from == begin ? from : from - 1) - begin);
        const auto last = static_cast<std::size_t>((after == end ? after : after + 1) - begin);
        Polyline reduced = decimate(std::span(line.x).subspan(first, last - first),
                                    std::span(line.y).subspan(first, last - first), columns);
        if (line.above)
            reduced = partAbove(reduced, line.limit);
        line.graph->setData(QVector<double>(reduced.x.begin(), reduced.x.end()),
                            QVector<double>(reduced.y.begin(), reduced.y.end()), true);
    }
}

void PlotView::Impl::placeEventLabels(int axisWidth) {
    const QFontMetricsF metrics(theme.font(10));
    const double scale = axisWidth / std::max(plot->xAxis->range().size(), 1e-12);
    double free = -1.0;
    for (const Event& event : events) {
        const double left = (event.t_s - plot->xAxis->range().lower) * scale;
        const double width = metrics.horizontalAdvance(event.label) + 6.0;
        const bool fits = left >= 0.0 && left >= free && left + width <= axisWidth && !event.label.isEmpty();
        event.text->setVisible(fits);
        if (fits)
            free = left + width;
    }
}

void PlotView::Impl::equaliseScale() {
    const QRect area = plot->axisRect()->rect();
    if (area.width() < 1 || area.height() < 1)
        return;
    const double xScale = plot->xAxis->range().size() / area.width();
    const double yScale = plot->yAxis->range().size() / area.height();
    if (xScale < yScale)
        plot->xAxis->setRange(plot->xAxis->range().center(), yScale * area.width(), Qt::AlignCenter);
    else
        plot->yAxis->setRange(plot->yAxis->range().center(), xScale * area.height(), Qt::AlignCenter);
}

} // namespace chiron::report
