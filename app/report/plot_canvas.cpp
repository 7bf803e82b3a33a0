// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/plot_canvas.h"

#include "report/plot_theme.h"
#include "report/plot_view.h"

#include <QSaveFile>
#include <qcustomplot.h>

namespace chiron::report {

QImage renderPanels(const std::vector<Panel>& panels, QSize size, double scale, const PlotTheme& theme) {
    QImage image(QSizeF(size * scale).toSize(), QImage::Format_RGB32);
    if (image.isNull())
        return image;
    image.fill(theme.paper);
    QCPPainter painter;
    if (!painter.begin(&image))
        return {};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::TextAntialiasing);
    painter.scale(scale, scale);
    for (const Panel& panel : panels)
        panel.view->paintTo(painter, panel.area);
    painter.end();
    // The size on paper is independent of the scale: 96 logical pixels per inch.
    image.setDotsPerMeterX(qRound(scale * 96.0 / 0.0254));
    image.setDotsPerMeterY(qRound(scale * 96.0 / 0.0254));
    return image;
}

core::Result<void> writePair(const QString& path, PlotView& left, PlotView& right, const PlotTheme& theme) {
    constexpr QSize kSize(960, 420);
    const double split = 0.46 * kSize.width();
    return writePng(path, renderPanels({{&left, QRectF(0, 0, split, kSize.height())},
                                        {&right, QRectF(split, 0, kSize.width() - split, kSize.height())}},
                                       kSize, kPictureScale, theme));
}

core::Result<void> writePng(const QString& path, const QImage& image) {
    if (image.isNull())
        return core::fail(core::ErrorCode::wrongUse,
                          path.toStdString() +
                              ": the picture is empty; expected a size of at least 1 x 1 pixels");
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return core::fail(core::ErrorCode::storage,
                          path.toStdString() + ": cannot be written: " + file.errorString().toStdString());
    if (!image.save(&file, "PNG") || !file.commit())
        return core::fail(core::ErrorCode::storage,
                          path.toStdString() + ": was not written: " + file.errorString().toStdString());
    return {};
}

} // namespace chiron::report
