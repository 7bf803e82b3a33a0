// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/check_record.h"

#include "report/plot_view.h"
#include "report/text_box.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QPageLayout>
#include <QPdfWriter>
#include <QSaveFile>
#include <algorithm>
#include <qcustomplot.h>

namespace chiron::report {

namespace {

// A4 in logical pixels of 1/96 inch.
constexpr int kResolution = 1200;
constexpr double kPageWidth = 210.0 / 25.4 * 96.0;
constexpr double kPageHeight = 297.0 / 25.4 * 96.0;
constexpr double kSide = 60.0;
constexpr double kTop = 54.0;
constexpr double kBottom = 54.0;
constexpr double kFoot = 40.0; // distance of the page number from the page's end
constexpr double kNameWidth = 150.0;
constexpr double kPlotHeight = 190.0;
constexpr double kWidth = kPageWidth - 2 * kSide;

/// Fills each page from top to bottom, then continues on the next one. Without a painter it only counts the
/// pages.
class Pages {
public:
    Pages(QPagedPaintDevice& device, QCPPainter& painter, const CheckRecord& record, const PlotTheme& theme,
          int count)
        : m_device(device), m_painter(painter), m_record(record), m_theme(theme), m_count(count) {
        begin();
    }

    /// Reserves space of this height; `drawn` draws into it.
    template <class Draw> void put(double height, Draw draw) {
        if (m_y + height > kPageHeight - kBottom && m_y > kTop) {
            ++m_page;
            if (draws())
                m_whole = m_device.newPage() && m_whole;
            m_y = kTop;
            begin();
        }
        if (draws()) {
            m_painter.save();
            draw(QRectF(kSide, m_y, kWidth, height));
            m_painter.restore();
        }
        m_y += height;
    }
    void text(const QString& words, const QFont& font, const QColor& ink, double after) {
        put(textHeight(words, font, kWidth), [&](const QRectF& box) {
            drawText(m_painter, box, words, {font, ink});
        });
        m_y += after;
    }
    bool whole() const { return m_whole; }
    int page() const { return m_page; }

private:
    bool draws() const { return m_count > 0; }

    void begin() {
        if (!draws())
            return;
        const double pixel = m_device.logicalDpiX() / 96.0;
        m_painter.resetTransform();
        m_painter.scale(pixel, pixel);
        const QString number =
            QCoreApplication::translate("CheckRecord", "Page %1 of %2").arg(m_page).arg(m_count);
        const QString foot =
            m_record.foot.isEmpty() ? number : m_record.foot + QStringLiteral("  ·  ") + number;
        drawText(m_painter, QRectF(kSide, kPageHeight - kFoot, kWidth, kFoot), foot,
                 {m_theme.font(9), m_theme.muted});
    }

    QPagedPaintDevice& m_device;
    QCPPainter& m_painter;
    const CheckRecord& m_record;
    const PlotTheme& m_theme;
    int m_count; ///< number of pages; 0: not known yet, so nothing is drawn
    int m_page = 1;
    double m_y = kTop;
    bool m_whole = true;
};

/// Names in a narrow column, values beside them.
void putHead(Pages& pages, QCPPainter& painter, const CheckRecord& record, const PlotTheme& theme) {
    const QFont font = theme.font(10);
    for (const auto& [name, value] : record.head) {
        const double height =
            std::max(textHeight(name, font, kNameWidth - 8), textHeight(value, font, kWidth - kNameWidth));
        pages.put(height + 2, [&](const QRectF& box) {
            drawText(painter, QRectF(box.left(), box.top(), kNameWidth - 8, height), name,
                     {font, theme.muted});
            drawText(painter, QRectF(box.left() + kNameWidth, box.top(), kWidth - kNameWidth, height), value,
                     {font, theme.ink});
        });
    }
    if (!record.head.empty())
        pages.text(QString(QLatin1Char(' ')), theme.font(6), theme.ink, 0);
}

void putTable(Pages& pages, QCPPainter& painter, const CheckTable& table, const PlotTheme& theme) {
    pages.text(table.title, theme.font(12, true), theme.ink, 4);
    for (std::size_t row = 0; row < table.lines.size(); ++row) {
        const QStringList& cells = table.lines[row];
        if (cells.isEmpty())
            continue;
        const QFont font = theme.font(10, row == 0);
        const double width = kWidth / static_cast<double>(cells.size());
        double height = 0.0;
        for (const QString& cell : cells)
            height = std::max(height, textHeight(cell, font, width - 8));
        pages.put(height + 6, [&](const QRectF& box) {
            for (qsizetype i = 0; i < cells.size(); ++i)
                drawText(
                    painter,
                    QRectF(box.left() + static_cast<double>(i) * width, box.top() + 2, width - 8, height),
                    cells[i], {font, theme.ink});
            painter.setPen(QPen(theme.rule, 0.8));
            painter.drawLine(box.bottomLeft(), box.bottomRight());
        });
    }
    pages.text(QString(QLatin1Char(' ')), theme.font(8), theme.ink, 0);
}

void putAll(Pages& pages, QCPPainter& painter, const CheckRecord& record, const PlotTheme& theme) {
    pages.text(record.title, theme.font(18, true), theme.accent, 2);
    pages.text(record.when, theme.font(10), theme.muted, 10);
    putHead(pages, painter, record, theme);
    pages.text(record.verdict, theme.font(13, true), theme.ink, 6);
    for (const QString& fact : record.facts)
        pages.text(fact, theme.font(10.5), theme.ink, 5);
    for (const CheckTable& table : record.tables)
        putTable(pages, painter, table, theme);
    for (PlotView* plot : record.plots)
        pages.put(kPlotHeight, [&](const QRectF& box) { plot->paintTo(painter, box.adjusted(0, 0, 0, -8)); });
}

core::Error notWritten(const QString& path, const QString& reason) {
    return {core::ErrorCode::storage, path.toStdString() + ": was not written: " + reason.toStdString()};
}

} // namespace

bool paintCheck(QPagedPaintDevice& device, const CheckRecord& record, const PlotTheme& theme) {
    QCPPainter painter;
    if (!painter.begin(&device))
        return false;
    painter.setMode(QCPPainter::pmVectorized);
    Pages counted(device, painter, record, theme, 0);
    putAll(counted, painter, record, theme);
    Pages pages(device, painter, record, theme, counted.page());
    putAll(pages, painter, record, theme);
    return painter.end() && pages.whole();
}

core::Result<void> writeCheckPdf(const QString& path, const CheckRecord& record, const PlotTheme& theme) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return tl::unexpected(notWritten(path, file.errorString()));
    QByteArray bytes;
    {
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter writer(&buffer);
        writer.setResolution(kResolution);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF(0, 0, 0, 0));
        writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
        writer.setTitle(record.title);
        if (!paintCheck(writer, record, theme))
            return tl::unexpected(notWritten(path, QStringLiteral("the pages could not be drawn")));
    }
    if (file.write(bytes) != bytes.size() || !file.commit())
        return tl::unexpected(notWritten(path, file.errorString()));
    return {};
}

} // namespace chiron::report
