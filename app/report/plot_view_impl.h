// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/decimate.h"
#include "report/plot_view.h"

#include <limits>
#include <qcustomplot.h>

namespace chiron::report {

/// The smallest and the largest of the values added; non-finite values are ignored.
struct DataRange {
    double low = 0.0;
    double high = 0.0;
    bool empty = true;

    void take(double value);
    /// The range widened by 5 % on each side; its width is never zero. A fixed end stays unchanged.
    QCPRange padded(const PlotAxis& axis) const;
};

/// The QCustomPlot behind a view, and the full series from which the line for each width is reduced.
struct PlotView::Impl {
    struct Line {
        QCPGraph* graph = nullptr; ///< owned by the plot
        std::vector<double> x;
        std::vector<double> y;
        bool above = false;
        double limit = 0.0;
    };
    struct Event {
        double t_s = 0.0;
        QString label;
        QCPItemText* text = nullptr; ///< owned by the plot
    };

    Impl(const PlotTheme& look, QWidget* parent);

    QCPGraph* addGraph(const QString& name);
    QPen pen(PlotStyle style, double width) const;
    QColor color(PlotStyle style) const;
    void addHorizontal(const QString& name, double value, const QPen& pen);
    void takeX(double value) { xRange.take(value); }
    void takeY(double value) { yRange.take(value); }

    /// Prepares the plot for a width and height in logical pixels: ranges, legend columns, lines, event
    /// labels.
    void prepare(QSize size);
    void arrangeLegend(int width);
    void fillLines(int columns);
    bool fixed() const { return xAxis.minimum && xAxis.maximum; } ///< true if the x axis has a fixed range
    void placeEventLabels(int axisWidth);
    void equaliseScale();

    void makeCursor();
    void seekTo(double pixel);

    PlotTheme theme;
    QCustomPlot* plot = nullptr;   ///< child of the view
    QCPItemLine* cursor = nullptr; ///< on its own layer; created when the cursor is first shown
    double cursorX = std::numeric_limits<double>::quiet_NaN();
    std::function<void(double)> seek;
    QCPTextElement* title = nullptr;
    PlotAxis xAxis;
    PlotAxis yAxis;
    DataRange xRange;
    DataRange yRange;
    bool equalScale = false;
    std::vector<Line> lines;
    std::vector<Event> events;
};

} // namespace chiron::report
