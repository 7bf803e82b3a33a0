// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/plot_theme.h"
#include "report/report_section.h"
#include "report/trial_outcome.h"
#include "report/word_table.h"

#include <QLocale>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace chiron::report {

class PlotView;

/// One trial on an elastic tube. A value is absent if the task has no such target or the tube was never held.
struct TubeTrialRow {
    int trial = 0; ///< from 0; displayed from 1
    TrialOutcome outcome = TrialOutcome::unfinished;
    std::optional<double> target_N;
    std::optional<double> error_N; ///< root mean square over its holds
    std::optional<double> inBand_s;
    double stretchMax_mm = 0.0;
    std::optional<double> overStretches;
    std::optional<double> drops;
    std::optional<double> retractionInBand_percent; ///< of a fold that had to be retracted
};

/// The results on an elastic tube, at 100 Hz (for each 10 ms the value farthest from zero). Values are NaN
/// between trials, and if a trial has no band or no mark.
struct TubeReport {
    struct Span {
        double begin_s = 0.0;
        double end_s = 0.0;
    };
    std::vector<double> t_s;
    std::vector<double> tension_N;
    std::vector<double> bandLow_N, bandHigh_N;
    std::vector<double> stretch_mm;
    std::vector<double> markLow_mm, markHigh_mm;
    std::vector<double> retraction_N; ///< pull on the fold over the tube; empty if there is no fold
    double retractionLow_N = 0.0, retractionHigh_N = 0.0;
    double overStretch_mm = 0.0; ///< 0: not known
    std::vector<Span> paused;
    std::vector<double> trialStart_s;
    std::vector<TubeTrialRow> rows;
};

/// The plots of an elastic tube over time. Each function creates a new view; empty data give an empty plot
/// with a note.
/// Thread: GUI.
///
/// Tension with the target band.
std::unique_ptr<PlotView> tensionPlot(const TubeReport& tube, const PlotTheme& theme);
/// The pull on the fold over the tube with its band; null if there was no fold.
std::unique_ptr<PlotView> retractionPlot(const TubeReport& tube, const PlotTheme& theme);
/// Stretch with the mark, if the task has one, and the length that counts as over-stretched.
std::unique_ptr<PlotView> stretchPlot(const TubeReport& tube, const PlotTheme& theme);
/// The results of each trial.
WordTable tubeTable(const TubeReport& tube, const QLocale& locale);

/// Tension and stretch over time, and the results of each trial.
class TubeSection final : public ReportSection {
public:
    explicit TubeSection(TubeReport tube) : m_tube(std::move(tube)) {}

    const TubeReport& tube() const { return m_tube; }
    void addTo(BlockMaker& blocks) const override;

private:
    TubeReport m_tube;
};

} // namespace chiron::report
