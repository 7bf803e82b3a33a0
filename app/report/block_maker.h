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

/// Builds the blocks that every report consists of: headings, named facts, tables and plots. They fit a body
/// of `width` logical pixels. The maker owns the plots, so it must outlive the painting.
/// Thread: GUI.
class BlockMaker {
public:
    BlockMaker(const PlotTheme& theme, double width) : m_theme(theme), m_width(width) {}
    BlockMaker(const BlockMaker&) = delete;
    BlockMaker& operator=(const BlockMaker&) = delete;

    const std::vector<Block>& blocks() const { return m_blocks; }
    const PlotTheme& theme() const { return m_theme; }

    void add(double height, double gap, std::function<void(QCPPainter&, const QRectF&)> paint,
             bool keep = false, int header = -1);
    void addHeading(const QString& text);
    /// Text in a frame, for facts that the reader must know before anything else.
    void addNotice(const QString& text);
    void addText(const QString& text, const QFont& font, const QColor& ink, double gap);
    /// Label above value; a dash if there is no value.
    void addPairs(const std::vector<std::pair<QString, QString>>& pairs, int columns);
    /// `shares` are the columns' fractions of the width. The head is repeated on each page.
    void addTable(const std::vector<QString>& head, const std::vector<std::vector<QString>>& rows,
                  const std::vector<double>& shares, const std::vector<bool>& rightAligned);
    /// Plots side by side, each with an equal share of the width.
    void addPlotRow(std::vector<std::unique_ptr<PlotView>> row, double height);
    /// One plot over the whole width; a null pointer is skipped.
    void addPlot(std::unique_ptr<PlotView> plot, double height);
    /// One row per trial. Columns are as wide as their words; the second one (how the trial ended) is
    /// left-aligned.
    void addTrialTable(const WordTable& table);
    /// Keeps a plot that a block paints alive for as long as the blocks.
    PlotView* keep(std::unique_ptr<PlotView> plot);

protected:
    ~BlockMaker() = default;

    const PlotTheme& m_theme;
    double m_width;
    std::vector<Block> m_blocks;
    std::vector<std::unique_ptr<PlotView>> m_plots;
};

} // namespace chiron::report
