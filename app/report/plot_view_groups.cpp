// SPDX-License-Identifier: GPL-3.0-or-later
// Points of several people in one plot, and the ellipse of their spread.
#include "report/plot_view.h"

#include "report/plot_view_impl.h"

#include <algorithm>
#include <array>

namespace chiron::report {

void PlotView::addGroupMarkers(const QString& name, const std::vector<PlotPoint>& points, int group) {
    constexpr std::array kShapes{QCPScatterStyle::ssCircle, QCPScatterStyle::ssSquare,
                                 QCPScatterStyle::ssTriangle, QCPScatterStyle::ssDiamond,
                                 QCPScatterStyle::ssTriangleInverted};
    constexpr std::array kStyles{PlotStyle::solidA, PlotStyle::dashedB, PlotStyle::dottedC,
                                 PlotStyle::dashDotD};
    const auto index = static_cast<std::size_t>(std::max(0, group));
    const QColor ink = m_impl->color(kStyles[index % kStyles.size()]);
    QCPGraph* graph = m_impl->addGraph(name);
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setPen(QPen(ink, 1.4));
    graph->setScatterStyle(QCPScatterStyle(kShapes[index % kShapes.size()], QPen(ink, 1.4),
                                           QBrush(index % 2 == 0 ? ink : m_impl->theme.paper), 8));
    for (const PlotPoint& point : points) {
        graph->addData(point.x, point.y);
        m_impl->takeX(point.x);
        m_impl->takeY(point.y);
    }
}

void PlotView::addEllipse(const QString& name, const PlotPoint& centre, double halfWidth, double halfHeight) {
    auto* ellipse = new QCPItemEllipse(m_impl->plot);
    ellipse->topLeft->setCoords(centre.x - halfWidth, centre.y + halfHeight);
    ellipse->bottomRight->setCoords(centre.x + halfWidth, centre.y - halfHeight);
    const QPen pen(m_impl->theme.ink, 1.6, Qt::DashLine);
    ellipse->setPen(pen);
    ellipse->setBrush(Qt::NoBrush);
    m_impl->addGraph(name)->setPen(pen);
    for (const double side : {-1.0, 1.0}) {
        m_impl->takeX(centre.x + side * halfWidth);
        m_impl->takeY(centre.y + side * halfHeight);
    }
}

void PlotView::addArrow(const QString& name, const PlotPoint& from, const PlotPoint& to) {
    auto* line = new QCPItemLine(m_impl->plot);
    line->start->setCoords(from.x, from.y);
    line->end->setCoords(to.x, to.y);
    line->setHead(QCPLineEnding::esSpikeArrow);
    const QPen pen(m_impl->theme.ink, 2.2);
    line->setPen(pen);
    m_impl->addGraph(name)->setPen(pen);
    for (const PlotPoint& end : {from, to}) {
        m_impl->takeX(end.x);
        m_impl->takeY(end.y);
    }
}

} // namespace chiron::report
