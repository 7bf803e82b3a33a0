// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/plot_theme.h"
#include "report/report_data.h"

#include <QRectF>

class QCPPainter;

namespace chiron::report {

inline constexpr double kHeadlineCardHeight = 138.0;

/// Paints a metric in large format: its name, its value, a scale with the benchmark band, the pass mark and
/// the position of the value, and the same in words.
/// Thread: GUI.
void paintHeadlineCard(QCPPainter& painter, const QRectF& box, const MetricRow& row, const PlotTheme& theme);

} // namespace chiron::report
