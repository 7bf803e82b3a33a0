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

/// One trial of object handling. The object's position at the end is relative to the target's centre, seen
/// from above.
struct HandlingTrialRow {
    int trial = 0;
    TrialOutcome outcome = TrialOutcome::unfinished;
    std::optional<double> squeezeMax_N;
    std::optional<double> overLimit_s;
    std::optional<double> x_mm, y_mm;
    std::optional<double> fromTarget_mm;
    bool taken = false;           ///< the object was held; if false, it is only the nearest one
    std::optional<bool> heaviest; ///< for a completed weighing: whether the heaviest one was chosen
};

struct HandlingReport {
    double squeezeLimit_N = 0.0;
    double targetRadius_mm = 0.0;
    std::vector<HandlingTrialRow> rows;
};

/// The largest squeeze of each trial with its limit. This function and the next create a new view.
/// Thread: GUI.
std::unique_ptr<PlotView> squeezePlot(const HandlingReport& handling, const PlotTheme& theme);
/// The position of each object at the end, seen from above around the target.
std::unique_ptr<PlotView> placePlot(const HandlingReport& handling, const PlotTheme& theme);
WordTable handlingTable(const HandlingReport& handling, const QLocale& locale);

/// The squeeze on each object, its final position, and the results of each trial.
class HandlingSection final : public ReportSection {
public:
    explicit HandlingSection(HandlingReport handling) : m_handling(std::move(handling)) {}

    const HandlingReport& handling() const { return m_handling; }
    void addTo(BlockMaker& blocks) const override;

private:
    HandlingReport m_handling;
};

} // namespace chiron::report
