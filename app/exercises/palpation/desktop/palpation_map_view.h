// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/report/palpation_map_painter.h"
#include "app/exercises/palpation/session/palpation_record.h"

#include <QWidget>
#include <optional>

namespace chiron::desktop {

/// What is drawn over the map of a recorded trial: truth, findings and what became of them. Pure.
report::PalpationMapView mapViewOf(const session::PalpationTrialRecord& record, const simulation::PalpationParameters& level,
                                   simulation::SurfaceMapKind kind);

/// A map of the searched surface on the screen, read aloud in words. GUI thread.
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
