// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "report/plot_theme.h"
#include "report/report_data.h"

#include <QString>

class QPagedPaintDevice;

namespace chiron::report {

/// Writes the printable report of one session: A4, PDF/A-1b with embedded fonts and metadata, plots as
/// vectors. Needs a QApplication (the offscreen platform is sufficient). Replaces `path` only once the whole
/// file is written.
/// Thread: GUI.
/// Errors: storage naming the path.
core::Result<void> writeSessionPdf(const QString& path, const ReportData& data, const PlotTheme& theme);

/// Paints the same pages on the caller's device. Returns false if the device cannot be painted on.
/// Thread: GUI.
bool paintSession(QPagedPaintDevice& device, const ReportData& data, const PlotTheme& theme);

/// Writes the pictures of a session into `folder` (created if missing): position.png, force.png, speed.png
/// and those of the exercise's own sections. Returns the paths of the files written.
/// Errors: storage.
core::Result<std::vector<QString>> writeSessionPngs(const QString& folder, const ReportData& data,
                                                    const PlotTheme& theme);

/// Writes the comparison of operators as one picture.
/// Errors: storage.
core::Result<void> writeComparisonPng(const QString& path, const ComparisonData& data,
                                      const PlotTheme& theme);

} // namespace chiron::report
