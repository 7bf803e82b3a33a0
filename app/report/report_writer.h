// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "report/plot_theme.h"
#include "report/report_data.h"

#include <QString>

class QPagedPaintDevice;

namespace chiron::report {

/// Writes the printable report of one session: A4, PDF/A-1b with embedded fonts and metadata, plots as
/// vectors. Needs a QApplication (the offscreen platform will do). GUI thread; replaces `path` only when the
/// whole file is written. Fails with storage, naming the path.
core::Result<void> writeSessionPdf(const QString& path, const ReportData& data, const PlotTheme& theme);

/// The same pages on somebody's own device. False where it cannot be painted on. GUI thread.
bool paintSession(QPagedPaintDevice& device, const ReportData& data, const PlotTheme& theme);

/// Writes the pictures of a session into `folder` (made if missing): position.png, force.png, speed.png and those of its exercise's own
/// sections. Returns the paths written. Fails with storage.
core::Result<std::vector<QString>> writeSessionPngs(const QString& folder, const ReportData& data,
                                                    const PlotTheme& theme);

/// Writes the comparison of operators as one picture. Fails with storage.
core::Result<void> writeComparisonPng(const QString& path, const ComparisonData& data,
                                      const PlotTheme& theme);

} // namespace chiron::report
