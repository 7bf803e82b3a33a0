// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "report/plot_theme.h"
#include "report/report_data.h"

#include <QStringList>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

class QCPPainter;

namespace chiron::report {

/// An axis: label with unit ("Force (N)") and, where wanted, a fixed range; otherwise the data choose it.
struct PlotAxis {
    QString label;
    std::optional<double> minimum;
    std::optional<double> maximum;
};

/// How a series is told apart: by its line (or marker) as well as by its colour.
enum class PlotStyle { solidA, dashedB, dottedC, dashDotD, longDashE };

struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
};

/// The one way to draw plots, over QCustomPlot, which stays hidden. A widget on screen, a picture or vectors
/// on paper. All calls on the GUI thread. Not copyable.
class PlotView : public QWidget {
public:
    explicit PlotView(const PlotTheme& theme, QWidget* parent = nullptr);
    ~PlotView() override;
    PlotView(const PlotView&) = delete;
    PlotView& operator=(const PlotView&) = delete;

    void setTitle(const QString& title);
    void setXAxis(const PlotAxis& axis);
    void setYAxis(const PlotAxis& axis);
    /// Ticks of the y axis on whole numbers alone: counts.
    void setYWholeNumbers();
    /// Names instead of numbers under the x axis, at 0, 1, 2 ...
    void setXCategories(const std::vector<QString>& names);
    /// The same scale on both axes (the shorter range is widened).
    void setEqualScale(bool equal);
    /// Off where a plot beside it explains the lines already.
    void setLegendShown(bool shown);
    /// What the legend names, in its order.
    QStringList legendTexts() const;

    /// A line; long series are reduced to first, minimum, maximum, last of each pixel column, so that every
    /// peak stays.
    void addLine(const QString& name, std::span<const double> x, std::span<const double> y, PlotStyle style);
    void addMarkers(const QString& name, const std::vector<PlotPoint>& points, PlotStyle style,
                    bool crosses = false);
    /// A number beside each point: how many observations it stands for. Those of another size than `points` are left out.
    void addCounts(const std::vector<PlotPoint>& points, const std::vector<int>& counts);
    /// A marker with a vertical bar from y - spread to y + spread; no bar where the spread is not finite.
    void addMeans(const QString& name, const std::vector<PlotPoint>& means,
                  const std::vector<double>& spreads);
    struct Interval {
        double low = 0.0;
        double high = 0.0;
    };
    /// A marker with a vertical bar between the ends of its interval; no bar where an end is not finite.
    /// Each trust has a shape of its own: a diamond; a triangle, and a cross for what is left out, with broken bars.
    enum class Trust { sound, doubtful, leftOut };
    void addEstimates(const QString& name, const std::vector<PlotPoint>& estimates,
                      const std::vector<Interval>& intervals, Trust trust = Trust::sound);
    /// Bars of one of `count` groups side by side around each x.
    void addBars(const QString& name, const std::vector<PlotPoint>& tops, PlotStyle style, int index,
                 int count);
    /// Markers of one of many groups (people): told apart by shape and filling as well as by colour, twenty of them.
    void addGroupMarkers(const QString& name, const std::vector<PlotPoint>& points, int group);
    /// An outline with its axes along the plot's: a spread in two directions.
    void addEllipse(const QString& name, const PlotPoint& centre, double halfWidth, double halfHeight);
    void addArrow(const QString& name, const PlotPoint& from, const PlotPoint& to);
    /// A horizontal line with its name in the legend.
    void addLimit(const QString& name, double value);
    /// The same for something to compare with that is no limit.
    void addReference(const QString& name, double value);
    /// Fills between `limit` and the line where the line is above it; whether it is anywhere. Without a name it is not in the legend.
    bool shadeAbove(const QString& name, std::span<const double> x, std::span<const double> y, double limit);
    void addHatchedSpans(const QString& name, const std::vector<TimeSpan>& spans);
    void addEvents(const std::vector<TimedEvent>& events);
    void addCircle(const QString& name, double radius);
    /// A note in the middle of an empty plot.
    void setNote(const QString& text);

    /// A filled band between two values, behind everything: what is usual, or published.
    void addBand(const QString& name, double low, double high);

    /// Shows this part of the x axis alone, with all that was recorded in it; what was fixed before is forgotten.
    void setXWindow(double low, double high);
    double xLow() const; ///< ends of what the x axis shows
    double xHigh() const;
    /// The same width left of the axis in plots that stand one above the other, so that one cursor stands in one column.
    /// Logical pixels at scale 1.
    void setLeftMargin(double pixels);
    /// A vertical line at `x`; moved alone, without drawing the plot again. Not a number: none.
    void showCursor(double x);
    double cursorX() const;
    /// Hears the x at which the plot is clicked or dragged, within the axis' range.
    void onSeek(std::function<void(double)> call);
    /// Where `x` lies in this widget, logical pixels.
    double pixelOf(double x) const;

    /// Draws the plot into `area` of any paint device whose logical unit is 1/96 inch (vectors on a PDF).
    void paintTo(QCPPainter& painter, const QRectF& area);
    /// Writes a PNG of `size` logical pixels at `scale` device pixels each. Fails with storage.
    core::Result<void> savePng(const QString& path, QSize size, double scale = 2.0);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace chiron::report
