// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "report/report_data.h"

#include <QWidget>

namespace chiron::desktop {

/// Draws a metric on its scale: the value as a pointer, the pass mark as a line, the benchmark as a band. The
/// three differ in shape as well as colour. The numbers stand as text beside the bar.
/// Thread: GUI.
class BandBar : public QWidget {
    Q_OBJECT
public:
    BandBar(const Theme& theme, const report::MetricRow& row, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    /// Position of a value along the bar, from 0 (left) to 1 (right).
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
