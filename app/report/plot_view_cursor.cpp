// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/plot_view.h"
#include "report/plot_view_impl.h"

#include <algorithm>
#include <cmath>

// The interactive parts of a plot on the screen: the cursor and seeking.
namespace chiron::report {

void PlotView::addBand(const QString& name, double low, double high) {
    auto* rect = new QCPItemRect(m_impl->plot);
    rect->setLayer(QStringLiteral("background"));
    rect->topLeft->setTypeX(QCPItemPosition::ptAxisRectRatio);
    rect->bottomRight->setTypeX(QCPItemPosition::ptAxisRectRatio);
    rect->topLeft->setCoords(0.0, high);
    rect->bottomRight->setCoords(1.0, low);
    rect->setPen(QPen(m_impl->theme.good, 1.0, Qt::DotLine));
    rect->setBrush(m_impl->theme.goodFill);
    QCPGraph* key = m_impl->addGraph(name);
    key->setPen(Qt::NoPen);
    key->setBrush(m_impl->theme.goodFill);
    m_impl->takeY(low);
    m_impl->takeY(high);
}

void PlotView::setLeftMargin(double pixels) {
    QCPAxisRect* rect = m_impl->plot->axisRect();
    rect->setAutoMargins(QCP::msRight | QCP::msTop | QCP::msBottom);
    QMargins margins = rect->margins();
    margins.setLeft(qRound(pixels * m_impl->theme.scale));
    rect->setMargins(margins);
}

void PlotView::Impl::makeCursor() {
    const QString name = QStringLiteral("cursor");
    plot->addLayer(name);
    // The cursor's layer is drawn separately, so that moving the cursor does not redraw the plot.
    plot->layer(name)->setMode(QCPLayer::lmBuffered);
    cursor = new QCPItemLine(plot);
    cursor->setLayer(name);
    cursor->setPen(QPen(theme.ink, 1.6 * theme.scale));
    cursor->setAntialiased(false);
    for (QCPItemPosition* end : {cursor->start, cursor->end})
        end->setTypeY(QCPItemPosition::ptAxisRectRatio);
}

void PlotView::showCursor(double x) {
    if (!m_impl->cursor)
        m_impl->makeCursor();
    m_impl->cursorX = x;
    m_impl->cursor->setVisible(std::isfinite(x));
    if (std::isfinite(x)) {
        m_impl->cursor->start->setCoords(x, 0.0);
        m_impl->cursor->end->setCoords(x, 1.0);
    }
    m_impl->cursor->layer()->replot();
}

double PlotView::cursorX() const {
    return m_impl->cursorX;
}

void PlotView::Impl::seekTo(double pixel) {
    const QCPRange range = plot->xAxis->range();
    if (seek)
        seek(std::clamp(plot->xAxis->pixelToCoord(pixel), range.lower, range.upper));
}

void PlotView::onSeek(std::function<void(double)> call) {
    const bool first = !m_impl->seek;
    m_impl->seek = std::move(call);
    if (!first)
        return;
    m_impl->plot->setCursor(Qt::PointingHandCursor);
    const auto follow = [this](QMouseEvent* event) {
        if (event->buttons() & Qt::LeftButton)
            m_impl->seekTo(event->position().x());
    };
    connect(m_impl->plot, &QCustomPlot::mousePress, this, follow);
    connect(m_impl->plot, &QCustomPlot::mouseMove, this, follow);
}

void PlotView::setXWindow(double low, double high) {
    m_impl->xAxis.minimum = low;
    m_impl->xAxis.maximum = high;
    m_impl->prepare(size());
    m_impl->plot->replot(QCustomPlot::rpQueuedReplot);
}

double PlotView::xLow() const {
    return m_impl->plot->xAxis->range().lower;
}

double PlotView::xHigh() const {
    return m_impl->plot->xAxis->range().upper;
}

double PlotView::pixelOf(double x) const {
    return m_impl->plot->xAxis->coordToPixel(x);
}

} // namespace chiron::report
