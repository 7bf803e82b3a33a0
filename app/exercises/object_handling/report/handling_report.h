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

/// One trial of object handling. Where the object lay at the end: from the target's middle, seen from above.
struct HandlingTrialRow {
    int trial = 0;
    TrialOutcome outcome = TrialOutcome::unfinished;
    std::optional<double> squeezeMax_N;
    std::optional<double> overLimit_s;
    std::optional<double> x_mm, y_mm;
    std::optional<double> fromTarget_mm;
    bool taken = false;           ///< it was held; else it is only the nearest one
    std::optional<bool> heaviest; ///< of a weighing that was done: whether the heaviest was chosen
};

struct HandlingReport {
    double squeezeLimit_N = 0.0;
    double targetRadius_mm = 0.0;
    std::vector<HandlingTrialRow> rows;
};

/// The largest squeeze of each trial with its limit. Each makes a new view (GUI thread) ...
std::unique_ptr<PlotView> squeezePlot(const HandlingReport& handling, const PlotTheme& theme);
/// ... and where each object lay at the end, seen from above about the target.
std::unique_ptr<PlotView> placePlot(const HandlingReport& handling, const PlotTheme& theme);
WordTable handlingTable(const HandlingReport& handling, const QLocale& locale);

/// How hard each object was squeezed and where it lay in the end, and what each trial came to.
class HandlingSection final : public ReportSection {
public:
    explicit HandlingSection(HandlingReport handling) : m_handling(std::move(handling)) {}

    const HandlingReport& handling() const { return m_handling; }
    void addTo(BlockMaker& blocks) const override;

private:
    HandlingReport m_handling;
};

} // namespace chiron::report
