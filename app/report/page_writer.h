// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "report/page_layout.h"
#include "report/plot_theme.h"

#include <QString>
#include <vector>

class QPagedPaintDevice;

namespace chiron::report {

/// The text around the body of every page, and the properties of the file.
struct PageFrame {
    QString heading; ///< top right: the type of report
    QString who;     ///< first line of the footer
    QString proof;   ///< second line of the footer: digests
    QString title;   ///< title of the PDF, with digests
    QString creator;
    QString site{}; ///< top left, beside the program's name; may be empty
};

/// The side margin and the width of the body of an A4 page in logical pixels of 1/96 inch.
inline constexpr double kPageSide = 60.0;
inline constexpr double kPageBodyWidth = 210.0 / 25.4 * 96.0 - 2 * kPageSide;

/// Writes blocks that fit kPageBodyWidth as A4 pages: PDF/A-1b with embedded fonts and vector graphics. Needs
/// a QApplication. Replaces `path` only once the whole file is written.
/// Thread: GUI.
/// Errors: storage naming the path.
core::Result<void> writePages(const QString& path, const PageFrame& frame, const std::vector<Block>& blocks,
                              const PlotTheme& theme);

/// Paints the same pages on the caller's device, at its resolution. Returns false if the device cannot be
/// painted on or refuses a new page.
/// Thread: GUI.
bool paintPages(QPagedPaintDevice& device, const PageFrame& frame, const std::vector<Block>& blocks,
                const PlotTheme& theme);

} // namespace chiron::report
