// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page_writer.h"

#include "report/report_text.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPdfWriter>
#include <QSaveFile>
#include <qcustomplot.h>

namespace chiron::report {

namespace {

// A4 in logical pixels of 1/96 inch, and the margins around the body.
constexpr int kResolution = 1200;
constexpr double kPixelsPerInch = 96.0;
constexpr double kPageWidth = 210.0 / 25.4 * kPixelsPerInch;
constexpr double kPageHeight = 297.0 / 25.4 * kPixelsPerInch;
constexpr double kHeaderHeight = 78.0;
constexpr double kFooterHeight = 62.0;
constexpr double kBodyHeight = kPageHeight - kHeaderHeight - kFooterHeight;

core::Error storageError(const QString& path, const QString& reason) {
    return {core::ErrorCode::storage, path.toStdString() + ": was not written: " + reason.toStdString()};
}

void paintHeader(QCPPainter& p, const PageFrame& frame, const PlotTheme& theme) {
    const QRectF box(kPageSide, 34, kPageBodyWidth, 26);
    p.setPen(theme.accent);
    p.setFont(theme.font(16, true));
    p.drawText(box, Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("Chiron"));
    const double besideName =
        QFontMetricsF(theme.font(16, true)).horizontalAdvance(QStringLiteral("Chiron")) + 14;
    p.setPen(theme.muted);
    p.setFont(theme.font(12));
    if (!frame.site.isEmpty()) {
        const QFontMetricsF metrics(theme.font(12));
        const double room = kPageBodyWidth - besideName - metrics.horizontalAdvance(frame.heading) - 14;
        p.drawText(box.adjusted(besideName, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(frame.site, Qt::ElideRight, room));
    }
    p.drawText(box, Qt::AlignRight | Qt::AlignVCenter, frame.heading);
    p.setPen(QPen(theme.accent, 1.6));
    p.drawLine(QPointF(kPageSide, 63), QPointF(kPageWidth - kPageSide, 63));
}

void paintFooter(QCPPainter& p, const PageFrame& frame, const PlotTheme& theme, int page, int pages) {
    const double top = kPageHeight - kFooterHeight + 14;
    p.setPen(QPen(theme.rule, 1.0));
    p.drawLine(QPointF(kPageSide, top), QPointF(kPageWidth - kPageSide, top));
    const QFont font = theme.font(9.5);
    const QFontMetricsF metrics(font);
    const QString number = Words::tr("Page %1 of %2").arg(page).arg(pages);
    const double right = metrics.horizontalAdvance(number) + 12;
    p.setFont(font);
    p.setPen(theme.muted);
    p.drawText(QRectF(kPageSide, top + 5, kPageBodyWidth, 14), Qt::AlignRight | Qt::AlignVCenter, number);
    p.drawText(QRectF(kPageSide, top + 5, kPageBodyWidth - right, 14), Qt::AlignLeft | Qt::AlignVCenter,
               metrics.elidedText(frame.who, Qt::ElideRight, kPageBodyWidth - right));
    p.drawText(QRectF(kPageSide, top + 18, kPageBodyWidth, 14), Qt::AlignLeft | Qt::AlignVCenter,
               metrics.elidedText(frame.proof, Qt::ElideRight, kPageBodyWidth));
}

void configure(QPdfWriter& writer, const PageFrame& frame) {
    writer.setResolution(kResolution);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
    writer.setTitle(frame.title);
    writer.setCreator(frame.creator);
}

} // namespace

bool paintPages(QPagedPaintDevice& device, const PageFrame& frame, const std::vector<Block>& blocks,
                const PlotTheme& theme) {
    const auto pages = paginate(blocks, kBodyHeight);
    const double pixel = device.logicalDpiX() / kPixelsPerInch;
    QCPPainter painter;
    if (!painter.begin(&device))
        return false;
    painter.setMode(QCPPainter::pmVectorized);
    for (std::size_t i = 0; i < pages.size(); ++i) {
        if (i > 0 && !device.newPage())
            return false;
        painter.resetTransform();
        painter.scale(pixel, pixel);
        paintHeader(painter, frame, theme);
        paintFooter(painter, frame, theme, static_cast<int>(i) + 1, static_cast<int>(pages.size()));
        for (const PlacedBlock& placed : pages[i]) {
            const Block& block = blocks[static_cast<std::size_t>(placed.block)];
            painter.save();
            block.paint(painter, QRectF(kPageSide, kHeaderHeight + placed.top, kPageBodyWidth, block.height));
            painter.restore();
        }
    }
    return painter.end();
}

core::Result<void> writePages(const QString& path, const PageFrame& frame, const std::vector<Block>& blocks,
                              const PlotTheme& theme) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return tl::unexpected(storageError(path, file.errorString()));
    QByteArray bytes;
    {
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter writer(&buffer);
        configure(writer, frame);
        if (!paintPages(writer, frame, blocks, theme))
            return tl::unexpected(storageError(path, QStringLiteral("the pages could not be drawn")));
    }
    if (file.write(bytes) != bytes.size() || !file.commit())
        return tl::unexpected(storageError(path, file.errorString()));
    return {};
}

} // namespace chiron::report
