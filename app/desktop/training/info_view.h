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

    /// The number of parts that it can do without, because another part shows the same (a plot beside a bar).
    /// None with the details, which a person has asked for.
    int mayGiveUp() const { return m_detailed ? 0 : static_cast<int>(m_spare.size()); }
    /// Hides the first `parts` of them and shows the others. Hidden parts continue to be measured.
    void giveUp(int parts);

protected:
    /// Registers `part` as a detail. A panel starts without its details.
    void addDetail(QWidget* part);
    /// Registers `part` as one of those that it can do without; the first registered is the first hidden.
    void addSpare(QWidget* part) { m_spare.push_back(part); }
    /// Adds the line at the bottom of the panel that says whether everything is recorded and on time.
    void addLoopLine(const Theme& theme, QBoxLayout& column);
    void showLoop(const haptics::DisplayState& state);

private:
    void placeLoopLine();

    std::vector<QWidget*> m_details;
    std::vector<QWidget*> m_spare;
    bool m_detailed = false;
    QLabel* m_loop = nullptr;
    bool m_lost = false; ///< samples were lost; shown with or without details
};

} // namespace chiron::desktop
