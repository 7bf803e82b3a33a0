// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/plot_theme.h"
#include "report/report_section.h"

#include <memory>
#include <utility>
#include <vector>

namespace chiron::report {

class PlotView;

/// How an endoscope kept to its canal, by depth: the largest value in each millimetre, on the way in and on the way out. What
/// was not passed is not a number. mm and degrees, as people read them.
struct InsertionProfile {
    std::vector<double> depth_mm; ///< middle of each millimetre, ascending
    std::vector<double> offsetIn_mm, offsetOut_mm;       ///< distance from the centre-line
    std::vector<double> alignmentIn_deg, alignmentOut_deg; ///< between the instrument and the canal
    double bend_mm = 0.0; ///< where the orientation has to change
    double neck_mm = 0.0; ///< the canal's end
    double goal_mm = 0.0; ///< depth that ends the insertion
    int landmarks = 0;    ///< to be seen
    int landmarksSeen = 0;
};

/// An endoscope in its canal over depth, in and out, with the bend and the bladder neck marked: distance from the centre-line, angle to it.
/// Each makes a new view (GUI thread).
std::unique_ptr<PlotView> offsetDepthPlot(const InsertionProfile& profile, const PlotTheme& theme);
std::unique_ptr<PlotView> alignmentDepthPlot(const InsertionProfile& profile, const PlotTheme& theme);

/// How the endoscope kept to its canal, by depth.
class InsertionSection final : public ReportSection {
public:
    explicit InsertionSection(InsertionProfile profile) : m_profile(std::move(profile)) {}

    const InsertionProfile& profile() const { return m_profile; }
    void addTo(BlockMaker& blocks) const override;
    core::Result<void> savePictures(const QDir& folder, const PlotTheme& theme, std::vector<QString>& written) const override;

private:
    InsertionProfile m_profile;
};

} // namespace chiron::report
