// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/plot_view.h"

#include "report/plot_canvas.h"
#include "report/plot_view_impl.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::report {

namespace {

/// A hidden row takes no space: an explicit minimum size overrides that of its text (0 would mean no explicit
/// size).
void takeRoom(QCPLayoutElement& row, bool shown) {
    row.setMinimumSize(shown ? QSize(0, 0) : QSize(1, 1));
    row.setMaximumSize(QWIDGETSIZE_MAX, shown ? QWIDGETSIZE_MAX : 1);
}

/// Shared because QCPAxis requires a shared pointer.
QSharedPointer<QCPAxisTicker> wholeNumbers() {
    const QSharedPointer<QCPAxisTickerFixed> ticker(new QCPAxisTickerFixed);
    ticker->setTickStep(1.0);
    ticker->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
    return ticker;
}

} // namespace

PlotView::PlotView(const PlotTheme& theme, QWidget* parent)
    : QWidget(parent), m_impl(std::make_unique<Impl>(theme, this)) {
    setMinimumSize(qRound(160 * theme.scale), qRound(120 * theme.scale));
}

PlotView::~PlotView() = default;

void PlotView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_impl->plot->setGeometry(rect());
    m_impl->prepare(size());
    m_impl->plot->replot(QCustomPlot::rpQueuedReplot);
}

void PlotView::setTitle(const QString& title) {
    m_impl->title->setText(title);
    m_impl->title->setVisible(!title.isEmpty());
    takeRoom(*m_impl->title, !title.isEmpty());
    m_impl->title->setMargins(title.isEmpty() ? QMargins() : QMargins(2, 0, 0, 2));
    setAccessibleName(title);
}

void PlotView::setXAxis(const PlotAxis& axis) {
    m_impl->xAxis = axis;
    m_impl->plot->xAxis->setLabel(axis.label);
}

void PlotView::setYAxis(const PlotAxis& axis) {
    m_impl->yAxis = axis;
    m_impl->plot->yAxis->setLabel(axis.label);
}

void PlotView::setXWholeNumbers() {
    m_impl->plot->xAxis->setTicker(wholeNumbers());
}

void PlotView::setYWholeNumbers() {
    m_impl->plot->yAxis->setTicker(wholeNumbers());
}

void PlotView::setXCategories(const std::vector<QString>& names) {
    // Shared because QCPAxis requires a shared pointer.
    const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
    for (std::size_t i = 0; i < names.size(); ++i)
        ticker->addTick(static_cast<double>(i), names[i]);
    m_impl->plot->xAxis->setTicker(ticker);
    m_impl->plot->xAxis->grid()->setVisible(false);
    m_impl->xAxis.minimum = -0.6;
    m_impl->xAxis.maximum = static_cast<double>(names.size()) - 0.4;
}

void PlotView::setEqualScale(bool equal) {
    m_impl->equalScale = equal;
}

void PlotView::setLegendShown(bool shown) {
    m_impl->plot->legend->setVisible(shown);
    takeRoom(*m_impl->plot->legend, shown);
}

QStringList PlotView::legendTexts() const {
    QStringList texts;
    for (int i = 0; i < m_impl->plot->legend->itemCount(); ++i)
        if (auto* item = qobject_cast<QCPPlottableLegendItem*>(m_impl->plot->legend->item(i)))
            texts << item->plottable()->name();
    return texts;
}

void PlotView::addLine(const QString& name, std::span<const double> x, std::span<const double> y,
                       PlotStyle style) {
    QCPGraph* graph = m_impl->addGraph(name);
    graph->setPen(m_impl->pen(style, 1.4));
    const std::size_t count = std::min(x.size(), y.size());
    for (std::size_t i = 0; i < count; ++i) {
        m_impl->takeX(x[i]);
        m_impl->takeY(y[i]);
    }
    if (count == 1) // a single sample is drawn as a point, because a line would be invisible
        graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(m_impl->color(style)),
                                               QBrush(m_impl->color(style)), 6));
    m_impl->lines.push_back({graph, {x.begin(), x.end()}, {y.begin(), y.end()}, false, 0.0});
}

void PlotView::addMarkers(const QString& name, const std::vector<PlotPoint>& points, PlotStyle style,
                          bool crosses) {
    QCPGraph* graph = m_impl->addGraph(name);
    graph->setLineStyle(QCPGraph::lsNone);
    const QColor ink = crosses ? m_impl->theme.bad : m_impl->color(style);
    graph->setPen(QPen(ink, 1.8));
    graph->setScatterStyle(
        crosses ? QCPScatterStyle(QCPScatterStyle::ssCross, QPen(ink, 1.8), Qt::NoBrush, 8)
                : QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(m_impl->theme.paper, 0.8), QBrush(ink), 8));
    for (const PlotPoint& point : points) {
        graph->addData(point.x, point.y);
        m_impl->takeX(point.x);
        m_impl->takeY(point.y);
    }
}

void PlotView::addCounts(const std::vector<PlotPoint>& points, const std::vector<int>& counts) {
    if (points.size() != counts.size())
        return;
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto* text = new QCPItemText(m_impl->plot);
        text->setText(m_impl->theme.locale.toString(counts[i]));
        text->setFont(m_impl->theme.font(9));
        text->setColor(m_impl->theme.muted);
        const bool above = i % 2 == 0; // so that neighbouring labels do not overlap
        text->setPositionAlignment(Qt::AlignHCenter | (above ? Qt::AlignBottom : Qt::AlignTop));
        text->setPadding(QMargins(0, 5, 0, 5));
        text->setClipToAxisRect(false);
        text->position->setCoords(points[i].x, points[i].y);
    }
}

void PlotView::addMeans(const QString& name, const std::vector<PlotPoint>& means,
                        const std::vector<double>& spreads) {
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i < means.size(); ++i) {
        const double spread = i < spreads.size() ? spreads[i] : std::numeric_limits<double>::quiet_NaN();
        intervals.push_back({means[i].y - spread, means[i].y + spread});
    }
    addEstimates(name, means, intervals);
}

void PlotView::addEstimates(const QString& name, const std::vector<PlotPoint>& estimates,
                            const std::vector<Interval>& intervals, Trust trust) {
    const QColor ink = m_impl->theme.ink;
    QCPGraph* graph = m_impl->addGraph(name);
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setPen(QPen(ink, 1.4));
    graph->setScatterStyle(QCPScatterStyle(trust == Trust::sound      ? QCPScatterStyle::ssDiamond
                                           : trust == Trust::doubtful ? QCPScatterStyle::ssTriangle
                                                                      : QCPScatterStyle::ssCross,
                                           QPen(ink, 1.2), QBrush(m_impl->theme.paper), 11));
    auto* bars = new QCPErrorBars(m_impl->plot->xAxis, m_impl->plot->yAxis);
    bars->removeFromLegend();
    bars->setDataPlottable(graph);
    bars->setPen(QPen(ink, 1.4, trust == Trust::sound ? Qt::SolidLine : Qt::DashLine));
    bars->setWhiskerWidth(9);
    bars->setSymbolGap(11);
    for (std::size_t i = 0; i < std::min(estimates.size(), intervals.size()); ++i) {
        const auto [low, high] = intervals[i];
        graph->addData(estimates[i].x, estimates[i].y);
        bars->addData(estimates[i].y - low, high - estimates[i].y);
        m_impl->takeX(estimates[i].x);
        for (const double edge : {estimates[i].y, low, high})
            m_impl->takeY(edge);
    }
}

void PlotView::addBars(const QString& name, const std::vector<PlotPoint>& tops, PlotStyle style, int index,
                       int count) {
    constexpr double kGroupWidth = 0.72;
    const double width = kGroupWidth / std::max(count, 1);
    auto* bars = new QCPBars(m_impl->plot->xAxis, m_impl->plot->yAxis);
    bars->setName(name);
    bars->setWidth(width * 0.92);
    const QColor ink = m_impl->color(style);
    bars->setPen(QPen(ink, 1.2));
    bars->setBrush(style == PlotStyle::solidA ? QBrush(ink) : QBrush(ink, Qt::BDiagPattern));
    m_impl->takeY(0.0);
    for (const PlotPoint& top : tops) {
        bars->addData(top.x + (index - 0.5 * (count - 1)) * width, top.y);
        m_impl->takeX(top.x - 0.5);
        m_impl->takeX(top.x + 0.5);
        m_impl->takeY(top.y);
    }
}

void PlotView::addLimit(const QString& name, double value) {
    QPen pen(m_impl->theme.bad, 1.4);
    pen.setDashPattern({8.0, 3.0, 2.0, 3.0});
    m_impl->addHorizontal(name, value, pen);
}

void PlotView::addReference(const QString& name, double value) {
    QPen pen(m_impl->theme.muted, 1.4);
    pen.setDashPattern({5.0, 3.0});
    m_impl->addHorizontal(name, value, pen);
}

bool PlotView::shadeAbove(const QString& name, std::span<const double> x, std::span<const double> y,
                          double limit) {
    const std::size_t count = std::min(x.size(), y.size());
    if (std::none_of(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(count),
                     [&](double v) { return v > limit; }))
        return false;
    QCPGraph* base = m_impl->addGraph(QString());
    base->setPen(Qt::NoPen);
    base->setData({x[0], x[count - 1]}, {limit, limit}, true);
    QCPGraph* graph = m_impl->addGraph(name);
    graph->setPen(Qt::NoPen);
    graph->setBrush(m_impl->theme.overFill);
    graph->setChannelFillGraph(base);
    m_impl->lines.push_back({graph, {x.begin(), x.end()}, {y.begin(), y.end()}, true, limit});
    return true;
}

void PlotView::addHatchedSpans(const QString& name, const std::vector<TimeSpan>& spans) {
    if (spans.empty())
        return;
    const QBrush hatch(m_impl->theme.muted, Qt::BDiagPattern);
    for (const TimeSpan& span : spans) {
        auto* rect = new QCPItemRect(m_impl->plot);
        rect->setLayer(QStringLiteral("grid"));
        rect->topLeft->setTypeY(QCPItemPosition::ptAxisRectRatio);
        rect->bottomRight->setTypeY(QCPItemPosition::ptAxisRectRatio);
        rect->topLeft->setCoords(span.begin_s, 0.0);
        rect->bottomRight->setCoords(span.end_s, 1.0);
        rect->setPen(Qt::NoPen);
        rect->setBrush(hatch);
        m_impl->takeX(span.begin_s);
        m_impl->takeX(span.end_s);
    }
    QCPGraph* key = m_impl->addGraph(name);
    key->setPen(Qt::NoPen);
    key->setBrush(hatch);
}

void PlotView::addEvents(const std::vector<TimedEvent>& events) {
    if (!events.empty())
        m_impl->plot->axisRect()->setMinimumMargins(QMargins(15, 20, 15, 15));
    for (const TimedEvent& event : events) {
        auto* line = new QCPItemStraightLine(m_impl->plot);
        line->setLayer(QStringLiteral("grid"));
        line->setPen(QPen(m_impl->theme.rule, 1.0));
        line->point1->setCoords(event.t_s, 0.0);
        line->point2->setCoords(event.t_s, 1.0);
        auto* text = new QCPItemText(m_impl->plot);
        text->setText(event.label);
        text->setFont(m_impl->theme.font(10));
        text->setColor(m_impl->theme.muted);
        // Above the axes, so that no data are covered.
        text->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
        text->setClipToAxisRect(false);
        text->setPadding(QMargins(1, 0, 3, 1));
        text->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
        text->position->setCoords(event.t_s, 0.0);
        m_impl->events.push_back({event.t_s, event.label, text});
    }
}

void PlotView::addCircle(const QString& name, double radius) {
    auto* circle = new QCPItemEllipse(m_impl->plot);
    circle->setLayer(QStringLiteral("grid"));
    circle->topLeft->setCoords(-radius, radius);
    circle->bottomRight->setCoords(radius, -radius);
    circle->setPen(QPen(m_impl->theme.ink, 1.4));
    circle->setBrush(m_impl->theme.panel);
    m_impl->addGraph(name)->setPen(QPen(m_impl->theme.ink, 1.4));
    for (const double edge : {-radius, radius}) {
        m_impl->takeX(edge);
        m_impl->takeY(edge);
    }
}

void PlotView::setNote(const QString& text) {
    auto* note = new QCPItemText(m_impl->plot);
    note->setText(text);
    note->setFont(m_impl->theme.font(12));
    note->setColor(m_impl->theme.muted);
    note->setBrush(m_impl->theme.paper);
    note->setPadding(QMargins(6, 3, 6, 3));
    note->position->setType(QCPItemPosition::ptAxisRectRatio);
    note->position->setCoords(0.5, 0.5);
}

void PlotView::paintTo(QCPPainter& painter, const QRectF& area) {
    const QSize size = area.size().toSize();
    m_impl->prepare(size);
    painter.save();
    painter.translate(area.topLeft());
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNonCosmetic);
    m_impl->plot->toPainter(&painter, size.width(), size.height());
    painter.restore();
}

core::Result<void> PlotView::savePng(const QString& path, QSize size, double scale) {
    return writePng(path,
                    renderPanels({{this, QRectF(QPointF(0, 0), QSizeF(size))}}, size, scale, m_impl->theme));
}

} // namespace chiron::report
