// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QImage>
#include <QRectF>
#include <QSize>
#include <QString>
#include <vector>

class QCPPainter;

namespace chiron::report {

class PlotView;
struct PlotTheme;

struct Panel {
    PlotView* view = nullptr; ///< borrowed
    QRectF area;              ///< in logical pixels of the picture
};

/// Draws panels into one picture of `size` logical pixels at `scale` device pixels each. GUI thread.
QImage renderPanels(const std::vector<Panel>& panels, QSize size, double scale, const PlotTheme& theme);

/// Device pixels of a logical one in the pictures that are written.
inline constexpr double kPictureScale = 2.0;

/// Writes two plots side by side as one picture. Fails with storage. GUI thread.
core::Result<void> writePair(const QString& path, PlotView& left, PlotView& right, const PlotTheme& theme);

/// Writes an image as PNG through a temporary file that replaces `path` only when complete. Fails with
/// storage (the path and the system's reason) and with wrongUse for an empty image.
core::Result<void> writePng(const QString& path, const QImage& image);

} // namespace chiron::report
