// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal_detection.h"
#include "app/exercises/palpation/report/palpation_map_painter.h"
#include "simulation/palpation/surface_map.h"

#include <optional>
#include <vector>

namespace chiron::report {

/// One finding, or a lump that was missed. Millimetres, as people read them.
struct PalpationFindingRow {
    enum class Kind { hit, falseAlarm, missed } kind = Kind::hit;
    int number = 0; ///< from 1; 0: missed
    double x_mm = 0.0;
    double y_mm = 0.0;
    double radius_mm = 0.0; ///< as reported; 0: not said. Of a missed lump: the true one
    int hardness = 0;       ///< the same
    int confidence = 0;     ///< 0: not said
    std::optional<double> error_mm;     ///< of a hit: from the lump's place
    std::optional<double> sizeError_mm; ///< of a hit whose size was said: reported − true radius
};

struct PalpationTrialReport {
    int trial = 0; ///< from 0; people see it from 1
    bool timedOut = false;
    simulation::SurfaceMap map;
    PalpationMapView view; ///< truth and findings; its kind is chosen when drawn
    std::vector<PalpationFindingRow> rows;
};

/// What a report tells of a palpation beside its metrics.
struct PalpationReport {
    std::vector<PalpationTrialReport> trials;
    core::DetectionCounts regions; ///< of all trials
};

/// Coverage and largest force of a trial side by side, lumps and findings over both.
void paintPalpationMaps(QPainter& painter, const QRectF& box, const PalpationTrialReport& trial, const PlotTheme& theme);

} // namespace chiron::report
