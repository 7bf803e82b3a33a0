// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "report/report_data.h"

#include <QWidget>

namespace chiron::desktop {

/// A metric on its scale: the value as a pointer, the pass mark as a line, the benchmark as a band. Shapes tell them apart
/// without colour; the numbers stand in words beside it. GUI thread.
class BandBar : public QWidget {
    Q_OBJECT
public:
    BandBar(const Theme& theme, const report::MetricRow& row, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    /// Where a value lies, 0 (left) to 1 (right) of the bar.
    double placeOf(double value) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRectF bar() const;
    double xOf(double value) const;

    const Theme& m_theme;
    report::MetricRow m_row;
    double m_low = 0.0;
    double m_high = 1.0;
};

} // namespace chiron::desktop
