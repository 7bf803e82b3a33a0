// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/plot_theme.h"
#include "report/report_section.h"

#include <memory>
#include <utility>
#include <vector>

namespace chiron::report {

class PlotView;

/// Signed error of one mark, in % of the sphere's radius (models.md §2.3).
struct ApexError {
    int trial = 0; ///< 0-based; displayed 1-based
    double x_percent = 0.0;
    double y_percent = 0.0;
    bool miss = false; ///< marked out of contact or farther away than R: kept, but drawn differently
    bool timedOut = false;
};

/// The errors of a session's marks. Each function creates a new view; without errors it is an empty plot with
/// a note.
/// Thread: GUI.
///
/// P2's figure 4, "% Error In Locating Virtual Spheres": the positions of the marks within the sphere's
/// outline.
std::unique_ptr<PlotView> apexScatterPlot(const std::vector<ApexError>& errors, const PlotTheme& theme);
/// The signed error in x and y of each trial.
std::unique_ptr<PlotView> apexTrialPlot(const std::vector<ApexError>& errors, const PlotTheme& theme);

/// The distance of each answer from the apex; without answers, a statement that no trial was marked.
class ApexSection final : public ReportSection {
public:
    explicit ApexSection(std::vector<ApexError> errors) : m_errors(std::move(errors)) {}

    const std::vector<ApexError>& errors() const { return m_errors; }
    void addTo(BlockMaker& blocks) const override;
    core::Result<void> savePictures(const QDir& folder, const PlotTheme& theme,
                                    std::vector<QString>& written) const override;

private:
    std::vector<ApexError> m_errors;
};

} // namespace chiron::report
