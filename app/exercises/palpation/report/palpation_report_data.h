// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/report/palpation_map_painter.h"
#include "core/signal_detection.h"
#include "simulation/palpation/surface_map.h"

#include <optional>
#include <vector>

namespace chiron::report {

/// One finding, or a lump that was missed. In millimetres, as displayed.
struct PalpationFindingRow {
    enum class Kind { hit, falseAlarm, missed } kind = Kind::hit;
    int number = 0; ///< from 1; 0 for a missed lump
    double x_mm = 0.0;
    double y_mm = 0.0;
    double radius_mm = 0.0;             ///< as reported; 0: not stated. For a missed lump, the true radius
    int hardness = 0;                   ///< as reported; 0: not stated. For a missed lump, the true hardness
    int confidence = 0;                 ///< 0: not stated
    std::optional<double> error_mm;     ///< of a hit: distance from the lump's position
    std::optional<double> sizeError_mm; ///< of a hit whose size was stated: reported − true radius
};

struct PalpationTrialReport {
    int trial = 0; ///< from 0; displayed from 1
    bool timedOut = false;
    simulation::SurfaceMap map;
    PalpationMapView view; ///< truth and findings; the map's kind is chosen when it is drawn
    std::vector<PalpationFindingRow> rows;
};

/// The content of a palpation's report beside its metrics.
struct PalpationReport {
    std::vector<PalpationTrialReport> trials;
    core::DetectionCounts regions; ///< of all trials
};

/// Paints coverage and largest force of a trial side by side, with lumps and findings over both.
void paintPalpationMaps(QPainter& painter, const QRectF& box, const PalpationTrialReport& trial,
                        const PlotTheme& theme);

} // namespace chiron::report
