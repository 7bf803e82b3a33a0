// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/page_layout.h"
#include "report/plot_theme.h"
#include "report/plot_view.h"
#include "report/report_data.h"

#include <memory>
#include <vector>

namespace chiron::report {

/// Makes the blocks of a session report, in reading order, for a body of `width` logical pixels. The plots
/// live in the maker, so it must outlive the painting. GUI thread.
class ReportBlocks {
public:
    ReportBlocks(const ReportData& data, const PlotTheme& theme, double width);
    ReportBlocks(const ReportBlocks&) = delete;
    ReportBlocks& operator=(const ReportBlocks&) = delete;

    const std::vector<Block>& blocks() const { return m_blocks; }

private:
    void addBanner();
    void addTitle();
    void addFacts();
    void addVerdict();
    void addHeadlines();
    void addMetrics();
    void addApex();
    void addInsertion();
    void addPlots();
    void addIntegrity();
    void addHeading(const QString& text);
    void addTable(const std::vector<QString>& head, const std::vector<std::vector<QString>>& rows,
                  const std::vector<double>& shares, const std::vector<bool>& rightAligned);
    void addPairs(const std::vector<std::pair<QString, QString>>& pairs, int columns);
    void add(double height, double gap, std::function<void(QCPPainter&, const QRectF&)> paint,
             bool keep = false, int header = -1);

    const ReportData& m_data;
    const PlotTheme& m_theme;
    double m_width;
    std::vector<Block> m_blocks;
    std::vector<std::unique_ptr<PlotView>> m_plots;
};

} // namespace chiron::report
