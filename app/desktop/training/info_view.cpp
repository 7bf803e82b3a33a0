// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/info_view.h"

#include "desktop/training/info_panel.h"
#include "desktop/widgets/kit.h"

namespace chiron::desktop {

void InfoView::setDetailed(bool detailed) {
    m_detailed = detailed;
    for (QWidget* part : m_details)
        part->setVisible(detailed);
    placeLoopLine();
    giveUp(0);
}

void InfoView::giveUp(int parts) {
    for (std::size_t i = 0; i < m_spare.size(); ++i)
        m_spare[i]->setVisible(static_cast<int>(i) >= parts);
    updateGeometry(); // now: whoever asks measures the height at once
}

void InfoView::addDetail(QWidget* part) {
    part->setVisible(m_detailed);
    m_details.push_back(part);
}

void InfoView::addLoopLine(const Theme& theme, QBoxLayout& column) {
    m_loop = kit::label(theme, {}, TextStyle::small, "muted");
    m_loop->setObjectName(QStringLiteral("training.loop"));
    column.addWidget(m_loop);
    placeLoopLine();
}

void InfoView::showLoop(const haptics::DisplayState& state) {
    m_loop->setText(InfoPanel::loopText(state));
    if (m_lost == (state.droppedFrames > 0))
        return;
    m_lost = state.droppedFrames > 0;
    placeLoopLine();
}

void InfoView::placeLoopLine() {
    if (m_loop)
        m_loop->setVisible(m_detailed || m_lost);
}

} // namespace chiron::desktop
