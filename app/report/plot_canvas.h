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
    PlotView* view = nullptr; ///< not owned
    QRectF area;              ///< in logical pixels of the picture
};

/// Draws panels into one picture of `size` logical pixels, with `scale` device pixels per logical pixel.
/// Thread: GUI.
QImage renderPanels(const std::vector<Panel>& panels, QSize size, double scale, const PlotTheme& theme);

/// Device pixels per logical pixel in picture files.
inline constexpr double kPictureScale = 2.0;

/// Writes two plots side by side as one picture.
/// Thread: GUI.
/// Errors: storage.
core::Result<void> writePair(const QString& path, PlotView& left, PlotView& right, const PlotTheme& theme);

/// Writes an image as PNG through a temporary file that replaces `path` only once it is complete.
/// Errors: storage with the path and the system's reason; wrongUse for an empty image.
core::Result<void> writePng(const QString& path, const QImage& image);

} // namespace chiron::report
