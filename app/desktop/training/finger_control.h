// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/pointer_control.h"

#include <deque>
#include <functional>
#include <span>
#include <vector>

namespace chiron::desktop {

/// Moves palpating fingers with one mouse and one keyboard. One hand moves at a time, with all its fingers;
/// the other hand keeps its position and pressure. In the air, wheel and keys lower a finger quickly. Once
/// one of the hand's fingers touches, they move it finely enough to press to a controlled depth. While the
/// left button is down the hand does not move, so that the click that marks does not displace it. H selects
/// the other hand. If the level has a pinch, G closes the hand's jaw and O opens it while the key is down.
/// Thread: GUI; the mailboxes outlive it.
class FingerControl final : public HandControl {
public:
    /// In contact: 0.1 to 0.35 N in tissue of 227 to 700 N/m.
    static constexpr double kMetresPerNotch = 0.0005;
    static constexpr double kKeyPress_m_per_s = 0.008; ///< in contact: Page Down and Page Up
    static constexpr double kTouch_N = 0.02;           ///< less counts as no contact

    static constexpr double kJawSpeed_rad_per_s = 1.0; ///< as in GrasperControl

    /// `mailboxes`: one per tool, ordered by hand, `fingers` (≥ 1) for each. `scale`, `mirrored`: as in
    /// PointerControl. `jaw`: the hands can pinch.
    FingerControl(std::span<devices::PointerMailbox* const> mailboxes, int fingers, double scale,
                  bool mirrored = false, bool jaw = false);

    void drag(QPointF pixels, bool lifting) noexcept override;
    void wheel(int eighthsOfDegree) noexcept override;
    std::span<const int> keys() const noexcept override { return m_keys; }
    bool keyDown(int key) override;
    bool keyUp(int key) override;
    void releaseKeys() override;
    void click() override; ///< "Here it is": marks under the first finger of the hand
    bool marks() const noexcept override { return true; }
    void buttonDown(bool) override { m_still = true; }
    void buttonUp() override { m_still = false; }
    void feel(const haptics::DisplayState& state) override;
    /// The first finger of the selected hand.
    int activeTool() const noexcept override { return m_hand * m_fingers; }

    int hands() const noexcept { return static_cast<int>(m_tips.size()) / m_fingers; }
    int hand() const noexcept { return m_hand; }
    void choose(int hand); ///< selects a hand, 0..hands() - 1; ignores others
    /// `tell` is called with each new active tool.
    void onChosen(std::function<void(int)> tell) { m_tell = std::move(tell); }

private:
    template <class Act> void eachFinger(Act act) {
        for (int i = 0; i < m_fingers; ++i)
            act(m_tips[static_cast<std::size_t>(m_hand * m_fingers + i)]);
    }
    bool isKey(int key) const;
    void moveJaw(int key, bool down);

    int m_fingers;
    std::vector<devices::PointerMailbox*> m_mailboxes;
    /// A deque, because elements must not move and HandControls cannot be copied.
    std::deque<PointerControl> m_tips;
    std::vector<int> m_keys;
    int m_hand = 0;
    bool m_still = false;
    bool m_closing = false, m_opening = false; ///< their keys are down
    std::function<void(int)> m_tell;
};

} // namespace chiron::desktop
