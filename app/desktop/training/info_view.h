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

/// What is measured right now, as far as the level allows it: one class a kind of exercise. Plain, it has what a person looks at
/// while they work; with all details also single components, coordinates, further plots and how the loop does. GUI thread.
class InfoView : public QFrame {
public:
    using QFrame::QFrame;
    /// Each frame: the newest state and every sample since the frame before.
    virtual void show(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) = 0;

    /// Also shows, or hides, the details. Hidden ones go on being measured.
    void setDetailed(bool detailed);
    bool detailed() const noexcept { return m_detailed; }

protected:
    /// `part` is a detail; a panel begins without its details.
    void addDetail(QWidget* part);
    /// The line at the panel's foot that says whether everything is recorded and on time.
    void addLoopLine(const Theme& theme, QBoxLayout& column);
    void showLoop(const haptics::DisplayState& state);

private:
    void placeLoopLine();

    std::vector<QWidget*> m_details;
    bool m_detailed = false;
    QLabel* m_loop = nullptr;
    bool m_lost = false; ///< samples: that is told in any view
};

} // namespace chiron::desktop
