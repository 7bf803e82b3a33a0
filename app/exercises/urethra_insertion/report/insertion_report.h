// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/plot_theme.h"
#include "report/report_data.h"
#include "report/report_section.h"

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace chiron::report {

class PlotView;

/// The deviation of an endoscope from its canal, by depth: the largest value in each millimetre, on the way
/// in and on the way out. Depths that were not passed hold NaN. Units are mm and degrees, as displayed.
struct InsertionProfile {
    std::vector<double> depth_mm;                          ///< middle of each millimetre, ascending
    std::vector<double> offsetIn_mm, offsetOut_mm;         ///< distance from the centre-line
    std::vector<double> alignmentIn_deg, alignmentOut_deg; ///< between the instrument and the canal
    double bend_mm = 0.0;                                  ///< depth at which the orientation has to change
    double neck_mm = 0.0;                                  ///< end of the canal
    double goal_mm = 0.0;                                  ///< depth that ends the insertion
    int landmarks = 0;                                     ///< number of landmarks to be seen
    int landmarksSeen = 0;
};

/// Plots of an endoscope in its canal over depth, in and out, with the bend and the bladder neck marked:
/// distance from the centre-line, and angle to it. Each function creates a new view.
/// Thread: GUI.
std::unique_ptr<PlotView> offsetDepthPlot(const InsertionProfile& profile, const PlotTheme& theme);
std::unique_ptr<PlotView> alignmentDepthPlot(const InsertionProfile& profile, const PlotTheme& theme);

/// The same over time, from the derived series of a recording with these ids: the distance in m and the angle
/// in rad. Each function creates a new view. Thread: GUI.
std::unique_ptr<PlotView> offsetPlot(const SampleSeries& series, std::string_view id, const PlotTheme& theme);
std::unique_ptr<PlotView> alignmentPlot(const SampleSeries& series, std::string_view id,
                                        const PlotTheme& theme);

/// The deviation of the endoscope from its canal, by depth.
class InsertionSection final : public ReportSection {
public:
    explicit InsertionSection(InsertionProfile profile) : m_profile(std::move(profile)) {}

    const InsertionProfile& profile() const { return m_profile; }
    void addTo(BlockMaker& blocks) const override;
    core::Result<void> savePictures(const QDir& folder, const PlotTheme& theme,
                                    std::vector<QString>& written) const override;

private:
    InsertionProfile m_profile;
};

} // namespace chiron::report
