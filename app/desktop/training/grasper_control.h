// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/pointer_control.h"

#include <deque>
#include <functional>
#include <span>
#include <vector>

namespace chiron::desktop {

/// Graspers moved by one mouse and one keyboard: one of them at a time, as PointerControl moves a point; the others stay where
/// they are. The jaw moves for as long as it is asked to and then stays: the left button or G closes it, the same with Shift or H
/// opens it. 1 to 4 choose the instrument. GUI thread; the mailboxes outlive it.
class GrasperControl final : public HandControl {
public:
    /// Open to closed in 1.6 s: slow enough to stop at a gentle hold.
    static constexpr double kJawSpeed_rad_per_s = 1.0;

    /// `mailboxes`: one a tool, at least one. `scale`, `mirrored`: as PointerControl.
    GrasperControl(std::span<devices::PointerMailbox* const> mailboxes, double scale, bool mirrored = false);

    void drag(QPointF pixels, bool lifting) noexcept override { hand().drag(pixels, lifting); }
    void wheel(int eighthsOfDegree) noexcept override { hand().wheel(eighthsOfDegree); }
    std::span<const int> keys() const noexcept override { return m_keys; }
    bool keyDown(int key) override;
    bool keyUp(int key) override;
    void releaseKeys() override;
    void click() override {} ///< nothing is marked with a grasper
    void buttonDown(bool other) override;
    void buttonUp() override;

    int tools() const noexcept { return static_cast<int>(m_mailboxes.size()); }
    int activeTool() const noexcept override { return m_active; }
    void choose(int tool); ///< 0..tools() - 1; others are ignored. What the hand held until now, it lets go
    void onChosen(std::function<void(int)> tell) { m_tell = std::move(tell); } ///< called with each new active tool

private:
    PointerControl& hand() noexcept { return m_hands[static_cast<std::size_t>(m_active)]; }
    void sendJaw();

    std::vector<devices::PointerMailbox*> m_mailboxes;
    std::deque<PointerControl> m_hands; ///< they do not move
    std::vector<int> m_keys;
    int m_active = 0;
    bool m_closingKey = false;
    bool m_openingKey = false;
    int m_button = 0; ///< -1: closes, 1: opens, 0: up
    std::function<void(int)> m_tell;
};

} // namespace chiron::desktop
