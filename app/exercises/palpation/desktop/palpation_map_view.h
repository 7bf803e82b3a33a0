// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/report/palpation_map_painter.h"
#include "app/exercises/palpation/session/palpation_record.h"

#include <QWidget>
#include <optional>

namespace chiron::desktop {

/// The overlay of a recorded trial's map: truth, and findings with their outcomes. Pure function.
report::PalpationMapView mapViewOf(const session::PalpationTrialRecord& record,
                                   const simulation::PalpationParameters& level,
                                   simulation::SurfaceMapKind kind);

/// A map of the searched surface on the screen, with a description for screen readers.
/// Thread: GUI.
class PalpationMapView final : public QWidget {
    Q_OBJECT
public:
    explicit PalpationMapView(const report::PlotTheme& look, QWidget* parent = nullptr);

    void show(const simulation::SurfaceMap& map, report::PalpationMapView view);
    const report::PalpationMapView& view() const { return m_view; }
    using QWidget::show;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    report::PlotTheme m_look;
    simulation::SurfaceMap m_map;
    report::PalpationMapView m_view;
};

} // namespace chiron::desktop
