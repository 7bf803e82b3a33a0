// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/plot_theme.h"
#include "report/report_data.h"

#include <QRectF>

class QCPPainter;

namespace chiron::report {

inline constexpr double kHeadlineCardHeight = 138.0;

/// A metric shown large: name, value, a scale with the benchmark band, the pass mark and where the value
/// lies, and the same in words. GUI thread.
void paintHeadlineCard(QCPPainter& painter, const QRectF& box, const MetricRow& row, const PlotTheme& theme);

} // namespace chiron::report
