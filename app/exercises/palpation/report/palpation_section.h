// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/report/palpation_report_data.h"
#include "report/report_section.h"

#include <utility>

namespace chiron::report {

/// The lumps found and missed, the sensitivity, and the maps of each trial with the truth.
class PalpationSection final : public ReportSection {
public:
    explicit PalpationSection(PalpationReport report) : m_report(std::move(report)) {}

    const PalpationReport& report() const { return m_report; }
    void addTo(BlockMaker& blocks) const override;
    core::Result<void> savePictures(const QDir& folder, const PlotTheme& theme,
                                    std::vector<QString>& written) const override;

private:
    PalpationReport m_report;
};

} // namespace chiron::report
