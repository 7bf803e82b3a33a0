// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/pointer_control.h"

#include <deque>
#include <functional>
#include <span>
#include <vector>

namespace chiron::desktop {

/// Fingers that palpate, moved by one mouse and one keyboard: one hand at a time, its fingers together; the other hand stays
/// where it is, pressing as it pressed. In the air wheel and keys lower a finger quickly; once one of the hand's fingers touches, finely
/// enough to press with a measured depth. While the
/// left button is down the hand stands still, so that the click that marks does not move it. H chooses the other hand. Where
/// the level has a pinch, G closes the hand's jaw and O opens it for as long as the key is down. GUI thread; the mailboxes outlive it.
class FingerControl final : public HandControl {
public:
    static constexpr double kMetresPerNotch = 0.0005;     ///< in contact: 0.1 to 0.35 N in tissue of 227 to 700 N/m
    static constexpr double kKeyPress_m_per_s = 0.008;    ///< in contact: Page Down and Page Up
    static constexpr double kTouch_N = 0.02;              ///< less is no contact

    static constexpr double kJawSpeed_rad_per_s = 1.0;    ///< as GrasperControl

    /// `mailboxes`: one a tool, hand by hand, `fingers` (≥ 1) of each. `scale`, `mirrored`: as PointerControl. `jaw`: they can pinch.
    FingerControl(std::span<devices::PointerMailbox* const> mailboxes, int fingers, double scale, bool mirrored = false, bool jaw = false);

    void drag(QPointF pixels, bool lifting) noexcept override;
    void wheel(int eighthsOfDegree) noexcept override;
    std::span<const int> keys() const noexcept override { return m_keys; }
    bool keyDown(int key) override;
    bool keyUp(int key) override;
    void releaseKeys() override;
    void click() override; ///< "here it is": under the first finger of the hand
    void buttonDown(bool) override { m_still = true; }
    void buttonUp() override { m_still = false; }
    void feel(const haptics::DisplayState& state) override;
    int activeTool() const noexcept override { return m_hand * m_fingers; } ///< the first finger of the hand

    int hands() const noexcept { return static_cast<int>(m_tips.size()) / m_fingers; }
    int hand() const noexcept { return m_hand; }
    void choose(int hand); ///< 0..hands() - 1; others are ignored
    void onChosen(std::function<void(int)> tell) { m_tell = std::move(tell); } ///< called with each new active tool

private:
    template <class Act> void eachFinger(Act act) {
        for (int i = 0; i < m_fingers; ++i)
            act(m_tips[static_cast<std::size_t>(m_hand * m_fingers + i)]);
    }
    bool isKey(int key) const;
    void moveJaw(int key, bool down);

    int m_fingers;
    std::vector<devices::PointerMailbox*> m_mailboxes;
    std::deque<PointerControl> m_tips; ///< they do not move; HandControls are not copied
    std::vector<int> m_keys;
    int m_hand = 0;
    bool m_still = false;
    bool m_closing = false, m_opening = false; ///< its keys are down
    std::function<void(int)> m_tell;
};

} // namespace chiron::desktop
