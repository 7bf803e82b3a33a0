// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/block_maker.h"
#include "report/text_box.h"

#include <algorithm>
#include <qcustomplot.h>

namespace chiron::report {

namespace {
constexpr double kCellPadding = 6.0;
constexpr double kRowPadding = 5.0;

struct TableRow {
    std::vector<QString> cells;
    std::vector<double> widths;
    std::vector<bool> rightAligned;
    QFont font;
    QColor ink;
    QColor rule;
    QColor fill; ///< invalid for none
};

void paintRow(QCPPainter& p, const QRectF& box, const TableRow& row) {
    if (row.fill.isValid())
        p.fillRect(box, row.fill);
    double left = box.left();
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        const QRectF cell(left + kCellPadding, box.top() + kRowPadding, row.widths[i] - 2 * kCellPadding,
                          box.height() - kRowPadding);
        drawText(p, cell, row.cells[i],
                 {row.font, row.ink, row.rightAligned[i] ? Qt::AlignRight : Qt::AlignLeft});
        left += row.widths[i];
    }
    p.setPen(QPen(row.rule, 0.8));
    p.drawLine(box.bottomLeft(), box.bottomRight());
}

} // namespace

void BlockMaker::addTable(const std::vector<QString>& head, const std::vector<std::vector<QString>>& rows,
                          const std::vector<double>& shares, const std::vector<bool>& rightAligned) {
    std::vector<double> widths;
    for (const double share : shares)
        widths.push_back(share * m_width);
    const int header = static_cast<int>(m_blocks.size());
    const auto addRow = [&](const std::vector<QString>& cells, bool isHead) {
        TableRow row{cells,
                     widths,
                     rightAligned,
                     m_theme.font(isHead ? 11 : 12, isHead),
                     isHead ? m_theme.muted : m_theme.ink,
                     isHead ? m_theme.muted : m_theme.rule,
                     isHead ? m_theme.panel : QColor()};
        double height = 0.0;
        for (std::size_t i = 0; i < cells.size(); ++i)
            height = std::max(height, textHeight(cells[i], row.font, widths[i] - 2 * kCellPadding));
        add(
            height + 2 * kRowPadding, isHead ? 4 : 0,
            [row = std::move(row)](QCPPainter& p, const QRectF& box) { paintRow(p, box, row); }, isHead,
            isHead ? -1 : header);
    };
    addRow(head, true);
    for (const std::vector<QString>& cells : rows)
        addRow(cells, false);
}

} // namespace chiron::report
