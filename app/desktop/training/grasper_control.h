// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/pointer_control.h"

#include <deque>
#include <functional>
#include <span>
#include <vector>

namespace chiron::desktop {

/// Moves graspers with one mouse and one keyboard. One of them moves at a time, as PointerControl moves a
/// point; the others keep their position. The jaw moves as long as the control is held and then keeps its
/// opening: the left button or G closes it, the same with Shift or H opens it. 1 to 4 select the instrument.
/// Thread: GUI; the mailboxes outlive it.
class GrasperControl final : public HandControl {
public:
    /// From open to closed in 1.6 s, which is slow enough to stop at a gentle hold.
    static constexpr double kJawSpeed_rad_per_s = 1.0;

    /// `mailboxes`: one per tool, at least one. `scale`, `mirrored`: as in PointerControl.
    GrasperControl(std::span<devices::PointerMailbox* const> mailboxes, double scale, bool mirrored = false);

    void drag(QPointF pixels, bool lifting) noexcept override { hand().drag(pixels, lifting); }
    void wheel(int eighthsOfDegree) noexcept override { hand().wheel(eighthsOfDegree); }
    std::span<const int> keys() const noexcept override { return m_keys; }
    bool keyDown(int key) override;
    bool keyUp(int key) override;
    void releaseKeys() override;
    void click() override {} ///< a grasper marks nothing
    void buttonDown(bool other) override;
    void buttonUp() override;

    int tools() const noexcept { return static_cast<int>(m_mailboxes.size()); }
    int activeTool() const noexcept override { return m_active; }
    /// Selects a tool, 0..tools() - 1; ignores others. Keys and buttons held for the previous tool are
    /// released.
    void choose(int tool);
    /// `tell` is called with each new active tool.
    void onChosen(std::function<void(int)> tell) { m_tell = std::move(tell); }

private:
    PointerControl& hand() noexcept { return m_hands[static_cast<std::size_t>(m_active)]; }
    void sendJaw();

    std::vector<devices::PointerMailbox*> m_mailboxes;
    std::deque<PointerControl> m_hands; ///< a deque, because elements must not move
    std::vector<int> m_keys;
    int m_active = 0;
    bool m_closingKey = false;
    bool m_openingKey = false;
    int m_button = 0; ///< -1: closes, 1: opens, 0: up
    std::function<void(int)> m_tell;
};

} // namespace chiron::desktop
