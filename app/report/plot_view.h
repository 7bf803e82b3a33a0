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

/// An axis: a label with unit ("Force (N)") and optionally a fixed range; without one, the data determine the
/// range.
struct PlotAxis {
    QString label;
    std::optional<double> minimum;
    std::optional<double> maximum;
};

/// The style that identifies a series: its line (or marker) as well as its colour.
enum class PlotStyle { solidA, dashedB, dottedC, dashDotD, longDashE };

struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
};

/// The only class that draws plots. It wraps QCustomPlot, which stays hidden, and draws a widget on the
/// screen, a picture, or vectors on paper. Not copyable.
/// Thread: GUI.
class PlotView : public QWidget {
public:
    explicit PlotView(const PlotTheme& theme, QWidget* parent = nullptr);
    ~PlotView() override;
    PlotView(const PlotView&) = delete;
    PlotView& operator=(const PlotView&) = delete;

    void setTitle(const QString& title);
    void setXAxis(const PlotAxis& axis);
    void setYAxis(const PlotAxis& axis);
    /// Restricts the ticks of an axis to whole numbers, for counts and for what is numbered.
    void setXWholeNumbers();
    void setYWholeNumbers();
    /// Names instead of numbers under the x axis, at 0, 1, 2 ...
    void setXCategories(const std::vector<QString>& names);
    /// Uses the same scale on both axes; the shorter range is widened.
    void setEqualScale(bool equal);
    /// Turn it off if a neighbouring plot already explains the lines.
    void setLegendShown(bool shown);
    /// The names in the legend, in its order.
    QStringList legendTexts() const;

    /// Adds a line. Long series are reduced to the first, minimum, maximum and last sample of each pixel
    /// column, so that every peak stays visible.
    void addLine(const QString& name, std::span<const double> x, std::span<const double> y, PlotStyle style);
    void addMarkers(const QString& name, const std::vector<PlotPoint>& points, PlotStyle style,
                    bool crosses = false);
    /// Writes a number beside each point: how many observations it represents. Draws nothing if `counts` and
    /// `points` differ in size.
    void addCounts(const std::vector<PlotPoint>& points, const std::vector<int>& counts);
    /// Adds markers with a vertical bar from y - spread to y + spread; without a bar if the spread is not
    /// finite.
    void addMeans(const QString& name, const std::vector<PlotPoint>& means,
                  const std::vector<double>& spreads);
    struct Interval {
        double low = 0.0;
        double high = 0.0;
    };
    /// Adds markers with a vertical bar between the ends of their interval; without a bar if an end is not
    /// finite. Each trust level has its own shape: a diamond if sound, a triangle if doubtful, a cross if
    /// left out; the bars of the latter two are dashed.
    enum class Trust { sound, doubtful, leftOut };
    void addEstimates(const QString& name, const std::vector<PlotPoint>& estimates,
                      const std::vector<Interval>& intervals, Trust trust = Trust::sound);
    /// Adds the bars of group `index` of `count` groups that stand side by side around each x.
    void addBars(const QString& name, const std::vector<PlotPoint>& tops, PlotStyle style, int index,
                 int count);
    /// Adds markers of one of many groups (people). Shape and fill distinguish them as well as colour, for up
    /// to twenty groups.
    void addGroupMarkers(const QString& name, const std::vector<PlotPoint>& points, int group);
    /// Adds an ellipse with its axes parallel to those of the plot, for a spread in two directions.
    void addEllipse(const QString& name, const PlotPoint& centre, double halfWidth, double halfHeight);
    void addArrow(const QString& name, const PlotPoint& from, const PlotPoint& to);
    /// A horizontal line with its name in the legend.
    void addLimit(const QString& name, double value);
    /// Does the same for a value to compare with that is not a limit.
    void addReference(const QString& name, double value);
    /// Fills the area between `limit` and the line where the line is above it. Returns whether it is above
    /// anywhere. An empty name does not appear in the legend.
    bool shadeAbove(const QString& name, std::span<const double> x, std::span<const double> y, double limit);
    void addHatchedSpans(const QString& name, const std::vector<TimeSpan>& spans);
    void addEvents(const std::vector<TimedEvent>& events);
    void addCircle(const QString& name, double radius);
    /// A note in the middle of an empty plot.
    void setNote(const QString& text);

    /// Fills a band between two values behind everything else, for usual or published values.
    void addBand(const QString& name, double low, double high);

    /// Shows only this part of the x axis, with all samples in it. Overrides an earlier fixed range.
    void setXWindow(double low, double high);
    double xLow() const; ///< ends of the visible range of the x axis
    double xHigh() const;
    /// Sets the same width to the left of the axis in plots that are stacked, so that their cursors align.
    /// Unit: logical pixels at scale 1.
    void setLeftMargin(double pixels);
    /// Shows a vertical line at `x`. Only the line is redrawn, not the plot. NaN hides it.
    void showCursor(double x);
    double cursorX() const;
    /// Sets the callback for clicks and drags in the plot; it receives the x value, clamped to the axis
    /// range.
    void onSeek(std::function<void(double)> call);
    /// The position of `x` in this widget, in logical pixels.
    double pixelOf(double x) const;

    /// Draws the plot into `area` of any paint device whose logical unit is 1/96 inch (as vectors on a PDF).
    void paintTo(QCPPainter& painter, const QRectF& area);
    /// Writes a PNG of `size` logical pixels with `scale` device pixels per logical pixel.
    /// Errors: storage.
    core::Result<void> savePng(const QString& path, QSize size, double scale = 2.0);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace chiron::report
