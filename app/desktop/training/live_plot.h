// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "desktop/training/column_trace.h"

#include <QLocale>
#include <QWidget>
#include <optional>

namespace chiron::desktop {

/// A scrolling plot of the last 10 s of a signal. Every peak is kept (ColumnTrace), the limit is a labelled
/// dashed line, and the area above it is filled. It is painted by hand, because it must take well under a
/// millisecond, 60 times per second.
/// Thread: GUI.
class LivePlot final : public QWidget {
    Q_OBJECT
public:
    static constexpr double kSpan_s = 10.0;

    /// `title` includes the unit ("Force (N)"). The axis starts at 0 and reaches at least `top`.
    LivePlot(const Theme& theme, const QLocale& locale, const QString& title, double top,
             std::optional<double> limit = {}, QWidget* parent = nullptr);

    void add(double t_s, double value) noexcept { m_trace.add(t_s, value); }
    /// A target range, drawn as a band with an edge; both 0: none.
    void setBand(double low, double high) noexcept {
        m_low = low;
        m_high = high;
    }
    const ColumnTrace& trace() const noexcept { return m_trace; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Frame; ///< position of the axes in one frame
    QString numberOf(double value) const;
    void paintAxes(QPainter& painter, const Frame& frame) const;
    void paintBand(QPainter& painter, const Frame& frame) const;
    void paintLimit(QPainter& painter, const Frame& frame) const;
    void paintSignal(QPainter& painter, const Frame& frame);

    const Theme& m_theme;
    QLocale m_locale;
    QString m_title;
    double m_top;
    std::optional<double> m_limit;
    double m_low = 0.0;
    double m_high = 0.0;
    ColumnTrace m_trace{kSpan_s};
    std::vector<QLine> m_lines; ///< kept between frames, so that scrolling allocates nothing
    std::vector<QLine> m_over;
};

} // namespace chiron::desktop
