// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_writer.h"

#include "report/page_layout.h"
#include "report/plot_canvas.h"
#include "report/report_blocks.h"
#include "report/report_text.h"
#include "report/session_plots.h"

#include <QBuffer>
#include <QDir>
#include <QPageLayout>
#include <QPdfWriter>
#include <QSaveFile>
#include <qcustomplot.h>

namespace chiron::report {

namespace {

// A4 in logical pixels of 1/96 inch, and what is kept free around the body.
constexpr int kResolution = 1200;
constexpr double kPixel = kResolution / 96.0;
constexpr double kPageWidth = 210.0 / 25.4 * 96.0;
constexpr double kPageHeight = 297.0 / 25.4 * 96.0;
constexpr double kSide = 60.0;
constexpr double kHeaderHeight = 78.0;
constexpr double kFooterHeight = 62.0;
constexpr double kBodyWidth = kPageWidth - 2 * kSide;
constexpr double kBodyHeight = kPageHeight - kHeaderHeight - kFooterHeight;

core::Error storageError(const QString& path, const QString& reason) {
    return {core::ErrorCode::storage, path.toStdString() + ": was not written: " + reason.toStdString()};
}

void paintHeader(QCPPainter& p, const PlotTheme& theme) {
    const QRectF box(kSide, 34, kBodyWidth, 26);
    p.setPen(theme.accent);
    p.setFont(theme.font(16, true));
    p.drawText(box, Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("Chiron"));
    p.setPen(theme.muted);
    p.setFont(theme.font(12));
    p.drawText(box, Qt::AlignRight | Qt::AlignVCenter, Words::tr("Session report"));
    p.setPen(QPen(theme.accent, 1.6));
    p.drawLine(QPointF(kSide, 63), QPointF(kPageWidth - kSide, 63));
}

void paintFooter(QCPPainter& p, const ReportData& data, const PlotTheme& theme, int page, int pages) {
    const double top = kPageHeight - kFooterHeight + 14;
    p.setPen(QPen(theme.rule, 1.0));
    p.drawLine(QPointF(kSide, top), QPointF(kPageWidth - kSide, top));
    const QFont font = theme.font(9.5);
    const QFontMetricsF metrics(font);
    const QString number = Words::tr("Page %1 of %2").arg(page).arg(pages);
    const double right = metrics.horizontalAdvance(number) + 12;
    p.setFont(font);
    p.setPen(theme.muted);
    p.drawText(QRectF(kSide, top + 5, kBodyWidth, 14), Qt::AlignRight | Qt::AlignVCenter, number);
    const auto joined = [](QStringList parts) {
        parts.removeAll(QString());
        return parts.join(QStringLiteral(" · "));
    };
    const QString who =
        joined({data.integrity.sessionId, formatMoment(data.startedUtc, data.offsetMinutes, theme.locale)});
    p.drawText(QRectF(kSide, top + 5, kBodyWidth - right, 14), Qt::AlignLeft | Qt::AlignVCenter,
               metrics.elidedText(who, Qt::ElideRight, kBodyWidth - right));
    const QString digest = data.integrity.recordingDigest;
    const QString proof =
        joined({data.demonstration ? Words::tr("Demonstration") : QString(), data.integrity.buildId,
                digest.isEmpty() ? Words::tr("no recording digest") : digest});
    p.drawText(QRectF(kSide, top + 18, kBodyWidth, 14), Qt::AlignLeft | Qt::AlignVCenter,
               metrics.elidedText(proof, Qt::ElideRight, kBodyWidth));
}

void configure(QPdfWriter& writer, const ReportData& data) {
    writer.setResolution(kResolution);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
    writer.setTitle(
        QStringLiteral("Chiron session report: %1, %2, session %3, recording %4")
            .arg(data.person, data.exerciseTitle, data.integrity.sessionId, data.integrity.recordingDigest));
    writer.setCreator(QStringLiteral("Chiron %1").arg(data.integrity.buildId).trimmed());
}

bool paintPages(QPdfWriter& writer, const ReportData& data, const PlotTheme& theme) {
    const ReportBlocks content(data, theme, kBodyWidth);
    const auto pages = paginate(content.blocks(), kBodyHeight);
    QCPPainter painter;
    if (!painter.begin(&writer))
        return false;
    painter.setMode(QCPPainter::pmVectorized);
    for (std::size_t i = 0; i < pages.size(); ++i) {
        if (i > 0 && !writer.newPage())
            return false;
        painter.resetTransform();
        painter.scale(kPixel, kPixel);
        paintHeader(painter, theme);
        paintFooter(painter, data, theme, static_cast<int>(i) + 1, static_cast<int>(pages.size()));
        for (const PlacedBlock& placed : pages[i]) {
            const Block& block = content.blocks()[static_cast<std::size_t>(placed.block)];
            painter.save();
            block.paint(painter, QRectF(kSide, kHeaderHeight + placed.top, kBodyWidth, block.height));
            painter.restore();
        }
    }
    return painter.end();
}

core::Result<void> save(PlotView& left, PlotView* right, const QString& path, QSize size,
                        const PlotTheme& theme) {
    constexpr double kScale = 2.0;
    std::vector<Panel> panels{{&left, QRectF(QPointF(0, 0), QSizeF(size))}};
    if (right) {
        const double split = 0.46 * size.width();
        panels = {{&left, QRectF(0, 0, split, size.height())},
                  {right, QRectF(split, 0, size.width() - split, size.height())}};
    }
    return writePng(path, renderPanels(panels, size, kScale, theme));
}

} // namespace

core::Result<void> writeSessionPdf(const QString& path, const ReportData& data, const PlotTheme& theme) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return tl::unexpected(storageError(path, file.errorString()));
    QByteArray bytes;
    {
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter writer(&buffer);
        configure(writer, data);
        if (!paintPages(writer, data, theme))
            return tl::unexpected(storageError(path, QStringLiteral("the pages could not be drawn")));
    }
    if (file.write(bytes) != bytes.size() || !file.commit())
        return tl::unexpected(storageError(path, file.errorString()));
    return {};
}

core::Result<std::vector<QString>> writeSessionPngs(const QString& folder, const ReportData& data,
                                                    const PlotTheme& theme) {
    const QDir directory(folder);
    if (!directory.mkpath(QStringLiteral(".")))
        return tl::unexpected(storageError(folder, QStringLiteral("the folder could not be made")));
    const QSize wide(900, 360);
    std::vector<QString> written;
    const auto write = [&](const char* name, std::unique_ptr<PlotView> left,
                           std::unique_ptr<PlotView> right) {
        const QString path = directory.filePath(QLatin1String(name));
        auto result = save(*left, right.get(), path, right ? QSize(960, 420) : wide, theme);
        if (result)
            written.push_back(path);
        return result;
    };
    if (auto done = write("position.png", positionPlot(data.series, theme), nullptr); !done)
        return tl::unexpected(done.error());
    if (auto done = write("force.png", forcePlot(data.series, data.forceLimit_N, theme), nullptr); !done)
        return tl::unexpected(done.error());
    if (auto done = write("speed.png", speedPlot(data.series, theme), nullptr); !done)
        return tl::unexpected(done.error());
    if (!data.apexErrors.empty()) {
        auto done = write("apex_errors.png", apexScatterPlot(data.apexErrors, theme),
                          apexTrialPlot(data.apexErrors, theme));
        if (!done)
            return tl::unexpected(done.error());
    }
    if (data.insertion) {
        auto done = write("insertion.png", offsetDepthPlot(*data.insertion, theme), alignmentDepthPlot(*data.insertion, theme));
        if (!done)
            return tl::unexpected(done.error());
    }
    return written;
}

core::Result<void> writeComparisonPng(const QString& path, const ComparisonData& data,
                                      const PlotTheme& theme) {
    return save(*comparisonPlot(data, theme), nullptr, path, QSize(900, 460), theme);
}

} // namespace chiron::report
