// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "haptics/display_state.h"
#include "session/level_cues.h"
#include "session/live_sample.h"

#include <QFrame>
#include <QLocale>
#include <span>
#include <vector>

class QBoxLayout;
class QLabel;

namespace chiron::desktop {

/// The live measurements as far as the level allows them; one derived class per kind of exercise. By default
/// it shows what a person watches while working; with details also single components, coordinates, further
/// plots and the state of the loop.
/// Thread: GUI.
class InfoView : public QFrame {
public:
    using QFrame::QFrame;
    /// Call once per frame with the newest state and every sample since the previous frame.
    virtual void show(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) = 0;

    /// Shows or hides the details. Hidden details continue to be measured.
    void setDetailed(bool detailed);
    bool detailed() const noexcept { return m_detailed; }

protected:
    /// Registers `part` as a detail. A panel starts without its details.
    void addDetail(QWidget* part);
    /// Adds the line at the bottom of the panel that says whether everything is recorded and on time.
    void addLoopLine(const Theme& theme, QBoxLayout& column);
    void showLoop(const haptics::DisplayState& state);

private:
    void placeLoopLine();

    std::vector<QWidget*> m_details;
    bool m_detailed = false;
    QLabel* m_loop = nullptr;
    bool m_lost = false; ///< samples were lost; shown with or without details
};

} // namespace chiron::desktop
