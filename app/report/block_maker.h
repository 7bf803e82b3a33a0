// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/page_layout.h"
#include "report/plot_theme.h"
#include "report/plot_view.h"
#include "report/word_table.h"

#include <memory>
#include <utility>
#include <vector>

namespace chiron::report {

/// What every report's blocks are made of: headings, named facts, tables, plots. For a body of `width` logical pixels. The plots live
/// in the maker, so it must outlive the painting. GUI thread.
class BlockMaker {
public:
    BlockMaker(const PlotTheme& theme, double width) : m_theme(theme), m_width(width) {}
    BlockMaker(const BlockMaker&) = delete;
    BlockMaker& operator=(const BlockMaker&) = delete;

    const std::vector<Block>& blocks() const { return m_blocks; }
    const PlotTheme& theme() const { return m_theme; }

    void add(double height, double gap, std::function<void(QCPPainter&, const QRectF&)> paint, bool keep = false, int header = -1);
    void addHeading(const QString& text);
    /// Words in a frame: what must be known before anything else is read.
    void addNotice(const QString& text);
    void addText(const QString& text, const QFont& font, const QColor& ink, double gap);
    /// Label above value; a dash where there is none.
    void addPairs(const std::vector<std::pair<QString, QString>>& pairs, int columns);
    /// `shares` of the width; the head is repeated on each page.
    void addTable(const std::vector<QString>& head, const std::vector<std::vector<QString>>& rows,
                  const std::vector<double>& shares, const std::vector<bool>& rightAligned);
    /// Plots side by side, each with an equal share of the width.
    void addPlotRow(std::vector<std::unique_ptr<PlotView>> row, double height);
    /// One plot over the whole width; null is left out.
    void addPlot(std::unique_ptr<PlotView> plot, double height);
    /// A row per trial: columns as wide as their words, the second one (how it ended) to the left.
    void addTrialTable(const WordTable& table);
    /// Keeps a plot that a block paints, for as long as the blocks.
    PlotView* keep(std::unique_ptr<PlotView> plot);

protected:
    ~BlockMaker() = default;

    const PlotTheme& m_theme;
    double m_width;
    std::vector<Block> m_blocks;
    std::vector<std::unique_ptr<PlotView>> m_plots;
};

} // namespace chiron::report
