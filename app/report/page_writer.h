// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "report/page_layout.h"
#include "report/plot_theme.h"

#include <QString>
#include <vector>

class QPagedPaintDevice;

namespace chiron::report {

/// What stands around the body of every page, and in the file's own properties.
struct PageFrame {
    QString heading; ///< top right: what kind of report
    QString who;     ///< first line of the footer
    QString proof;   ///< second line of the footer: digests
    QString title;   ///< of the PDF, with digests
    QString creator;
    QString site{};  ///< top left, beside the program's name; may be empty
};

/// Of an A4 page in logical pixels of 1/96 inch.
inline constexpr double kPageSide = 60.0;
inline constexpr double kPageBodyWidth = 210.0 / 25.4 * 96.0 - 2 * kPageSide;

/// Puts blocks made for kPageBodyWidth on A4 pages: PDF/A-1b with embedded fonts, vectors. Needs a QApplication. GUI thread; replaces
/// `path` only when the whole file is written. Failure: storage, naming the path.
core::Result<void> writePages(const QString& path, const PageFrame& frame, const std::vector<Block>& blocks, const PlotTheme& theme);

/// The same pages on somebody's own device, at its resolution. False where it cannot be painted on, or gives no further page. GUI thread.
bool paintPages(QPagedPaintDevice& device, const PageFrame& frame, const std::vector<Block>& blocks, const PlotTheme& theme);

} // namespace chiron::report
