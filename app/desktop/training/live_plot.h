// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "desktop/training/column_trace.h"

#include <QLocale>
#include <QWidget>
#include <optional>

namespace chiron::desktop {

/// A signal's last 10 s, scrolling: every peak stays (ColumnTrace), the limit is a dashed line with its word, what lies
/// above it is filled. Painted by hand, because it must take well under a millisecond 60 times a second. GUI thread.
class LivePlot final : public QWidget {
    Q_OBJECT
public:
    static constexpr double kSpan_s = 10.0;

    /// `title` with its unit ("Force (N)"); the axis begins at 0 and at least reaches `top`.
    LivePlot(const Theme& theme, const QLocale& locale, const QString& title, double top, std::optional<double> limit = {},
             QWidget* parent = nullptr);

    void add(double t_s, double value) noexcept { m_trace.add(t_s, value); }
    /// A target between two values, drawn as a band with an edge; both 0: none.
    void setBand(double low, double high) noexcept { m_low = low; m_high = high; }
    const ColumnTrace& trace() const noexcept { return m_trace; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Frame; ///< where the axes lie in one picture
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
    std::vector<QLine> m_lines; ///< kept between pictures: no allocation while it scrolls
    std::vector<QLine> m_over;
};

} // namespace chiron::desktop
