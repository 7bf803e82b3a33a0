// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/block_maker.h"
#include "report/report_data.h"

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
    void addForce();
    void addCriticalErrors();
    void addPlots();
    void addIntegrity();

    const ReportData& m_data;
};

} // namespace chiron::report
