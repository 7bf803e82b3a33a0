// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/block_maker.h"

#include "report/text_box.h"

#include <QFontMetricsF>
#include <algorithm>
#include <numeric>
#include <qcustomplot.h>

namespace chiron::report {

namespace {
constexpr double kBody = 12.5;
constexpr double kPlotGap = 8.0;
} // namespace

void BlockMaker::add(double height, double gap, std::function<void(QCPPainter&, const QRectF&)> paint,
                     bool keep, int header) {
    m_blocks.push_back({height, gap, keep, header, std::move(paint)});
}

void BlockMaker::addHeading(const QString& words) {
    add(
        24, 18,
        [this, words](QCPPainter& p, const QRectF& box) {
            p.setFont(m_theme.font(15, true));
            p.setPen(m_theme.ink);
            p.drawText(box, Qt::AlignLeft | Qt::AlignVCenter, words);
        },
        true);
}

void BlockMaker::addNotice(const QString& words) {
    const QFont font = m_theme.font(12, true);
    add(textHeight(words, font, m_width - 24) + 12, 6, [this, words, font](QCPPainter& p, const QRectF& box) {
        p.setPen(QPen(m_theme.warning, 1.0));
        p.setBrush(m_theme.warningFill);
        p.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        drawText(p, box.adjusted(12, 6, -12, 0), words, {font, m_theme.warning});
    });
}

void BlockMaker::addText(const QString& words, const QFont& font, const QColor& ink, double gap) {
    add(textHeight(words, font, m_width), gap, [=](QCPPainter& p, const QRectF& box) {
        drawText(p, box, words, {font, ink});
    });
}

void BlockMaker::addPairs(const std::vector<std::pair<QString, QString>>& pairs, int columns) {
    const double column = m_width / columns;
    const double inner = column - 14;
    for (std::size_t first = 0; first < pairs.size(); first += static_cast<std::size_t>(columns)) {
        const std::size_t end = std::min(pairs.size(), first + static_cast<std::size_t>(columns));
        const std::vector<std::pair<QString, QString>> row(pairs.begin() + static_cast<std::ptrdiff_t>(first),
                                                           pairs.begin() + static_cast<std::ptrdiff_t>(end));
        double height = 0.0;
        for (const auto& pair : row)
            height = std::max(height, textHeight(pair.second, m_theme.font(kBody), inner));
        add(15 + height, first == 0 ? 12 : 6, [this, row, column, inner](QCPPainter& p, const QRectF& box) {
            double left = box.left();
            for (const auto& [label, value] : row) {
                drawText(p, QRectF(left, box.top(), inner, 15), label, {m_theme.font(10.5), m_theme.muted});
                drawText(p, QRectF(left, box.top() + 15, inner, box.height() - 15),
                         value.isEmpty() ? QStringLiteral("–") : value, {m_theme.font(kBody), m_theme.ink});
                left += column;
            }
        });
    }
}

void BlockMaker::addPlotRow(std::vector<std::unique_ptr<PlotView>> row, double height) {
    std::vector<PlotView*> views;
    for (auto& plot : row) {
        views.push_back(plot.get());
        m_plots.push_back(std::move(plot));
    }
    if (views.empty())
        return;
    add(height, kPlotGap, [views](QCPPainter& p, const QRectF& box) {
        const auto count = static_cast<double>(views.size());
        const double width = (box.width() - kPlotGap * (count - 1.0)) / count;
        for (std::size_t i = 0; i < views.size(); ++i)
            views[i]->paintTo(p, QRectF(box.left() + static_cast<double>(i) * (width + kPlotGap), box.top(),
                                        width, box.height()));
    });
}

void BlockMaker::addPlot(std::unique_ptr<PlotView> plot, double height) {
    if (!plot)
        return;
    PlotView* view = keep(std::move(plot));
    add(height, kPlotGap, [view](QCPPainter& p, const QRectF& box) { view->paintTo(p, box); });
}

PlotView* BlockMaker::keep(std::unique_ptr<PlotView> plot) {
    m_plots.push_back(std::move(plot));
    return m_plots.back().get();
}

void BlockMaker::addTrialTable(const WordTable& table) {
    // Columns are as wide as the longest word of their heading and their longest cell, so that no word is
    // broken in any language.
    const QFontMetricsF head(m_theme.font(11, true));
    const QFontMetricsF body(m_theme.font(12));
    constexpr double kPadding = 12.5; // padding of a cell, and rounding
    std::vector<double> widths;
    for (std::size_t column = 0; column < table.head.size(); ++column) {
        double width = 0.0;
        for (const QString& word : table.head[column].split(QLatin1Char(' ')))
            width = std::max(width, head.horizontalAdvance(word));
        for (const std::vector<QString>& row : table.rows)
            width = std::max(width, body.horizontalAdvance(row[column]));
        widths.push_back(width + kPadding);
    }
    const double sum = std::accumulate(widths.begin(), widths.end(), 0.0);
    for (double& width : widths)
        width /= sum;
    std::vector<bool> right(table.head.size(), true);
    right[1] = false; // the outcome, in words
    addTable(table.head, table.rows, widths, right);
}

} // namespace chiron::report
