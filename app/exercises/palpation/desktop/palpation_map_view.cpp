// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_map_view.h"

#include <QPainter>

namespace chiron::desktop {

report::PalpationMapView mapViewOf(const session::PalpationTrialRecord& record,
                                   const simulation::PalpationParameters& level,
                                   simulation::SurfaceMapKind kind) {
    report::PalpationMapView view;
    view.kind = kind;
    view.bands = session::mapBandsOf(level);
    view.regionColumns = level.regionColumns;
    view.regionRows = level.regionRows;
    const scoring::PalpationAnswer& answer = record.answer;
    for (std::size_t i = 0; i < answer.truth.lumps.size(); ++i) {
        const scoring::LumpTruth& lump = answer.truth.lumps[i];
        const bool found = scoring::foundBy(answer.matches, static_cast<int>(i)) != nullptr;
        view.lumps.push_back(
            {lump.place_W.x(), lump.place_W.y(), lump.depth_m, lump.radius_m, lump.hardness, found});
    }
    for (const scoring::FindingMatch& match : answer.matches) {
        const simulation::Finding& finding = answer.findings.list()[static_cast<std::size_t>(match.finding)];
        view.findings.push_back(
            {match.finding + 1, finding.p_W[0], finding.p_W[1], finding.radius_m,
             match.hit() ? simulation::FindingOutcome::hit : simulation::FindingOutcome::falseAlarm, false});
    }
    return view;
}

PalpationMapView::PalpationMapView(const report::PlotTheme& look, QWidget* parent)
    : QWidget(parent), m_look(look) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PalpationMapView::show(const simulation::SurfaceMap& map, report::PalpationMapView view) {
    m_map = map;
    m_view = std::move(view);
    const report::PalpationMapPainter painter(m_map, m_view, m_look);
    setAccessibleName(painter.title());
    setAccessibleDescription(painter.words());
    update();
}

void PalpationMapView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    report::PalpationMapPainter(m_map, m_view, m_look).paint(painter, rect());
}

} // namespace chiron::desktop
