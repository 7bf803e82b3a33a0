// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/plots/plot_theme_of.h"
#include "desktop/theme/theme.h"
#include "report/plot_view.h"
#include "report/word_table.h"

#include <QWidget>
#include <memory>

class QVBoxLayout;

namespace chiron::desktop {

// Building blocks for the exercises' parts of a debrief. Thread: GUI.

/// A vertical column of widgets without a margin.
struct PartColumn {
    explicit PartColumn(const Theme& theme);
    std::unique_ptr<QWidget> holder;
    QVBoxLayout* layout;
};

/// A plot with a minimum height. The caller's layout owns it.
QWidget* partPlot(const Theme& theme, std::unique_ptr<report::PlotView> view, const char* name,
                  int height_px);
/// The result of each trial, as a table that shows all its rows without scrolling. The caller's layout owns
/// it.
QWidget* trialTable(const Theme& theme, const report::WordTable& words, const char* name);

} // namespace chiron::desktop
