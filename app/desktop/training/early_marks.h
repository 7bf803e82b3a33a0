// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/display_state.h"

#include <array>
#include <cstdint>
#include <optional>

namespace chiron::desktop {

/// Tells which marks were meant for what the screen showed before: the second press of a double click on
/// "Go", "Continue" or "Resume", or a click to go on with the next trial when that has just begun by itself.
/// It would mark a place in the air and lose the trial. A mark is early within kWait_ms after the person went
/// on or a trial began, unless the tool has been moved since. An early mark is not sent, so that recordings
/// and their replay know nothing of it. Thread: GUI.
class EarlyMarks {
public:
    static constexpr std::int64_t kWait_ms = 500; ///< longer than a double click (400 ms in Qt)
    /// Assumption: a hand that presses twice moves less than this, and one that looks for a place moves more.
    static constexpr double kMoved_m = 0.003;

    void wentOn(std::int64_t now_ms); ///< the person has started the session, or left a pause
    /// Call once per frame with the newest state.
    void look(const haptics::DisplayState& state, std::int64_t now_ms);
    /// Whether a mark at this time would be early. `now_ms`: of any steady clock, the same for all calls.
    bool areEarly(std::int64_t now_ms) const { return m_until_ms && now_ms < *m_until_ms; }

private:
    bool moved(const haptics::DisplayState& state) const;

    std::optional<std::int64_t> m_until_ms; ///< empty: no mark is early
    bool m_running = false;
    int m_trial = -1;
    /// The tools' positions at the first state after the wait began; empty before it.
    std::optional<std::array<std::array<double, 3>, core::kMaxTools>> m_from_m;
};

} // namespace chiron::desktop
