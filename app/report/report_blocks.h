// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/block_maker.h"
#include "report/report_data.h"
#include "report/word_table.h"

namespace chiron::report {

/// Makes the blocks of a session report, in reading order.
class ReportBlocks : public BlockMaker {
public:
    ReportBlocks(const ReportData& data, const PlotTheme& theme, double width);

private:
    void addBanner();
    void addTitle();
    void addFacts();
    void addVerdict();
    void addHeadlines();
    void addMetrics();
    void addApex();
    void addInsertion();
    void addPalpation();
    void addFindings(const PalpationReport& report);
    void addMaps(const PalpationTrialReport& trial);
    void addTube();
    void addHandling();
    void addWords(const WordTable& table);
    void addForce();
    void addCriticalErrors();
    /// Null is left out.
    void addPlot(std::unique_ptr<PlotView> plot, double height);
    void addPlots();
    void addIntegrity();

    const ReportData& m_data;
};

} // namespace chiron::report
