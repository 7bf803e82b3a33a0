// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/hand_control.h"
#include "devices/api/endoscope_mailbox.h"

#include <set>

namespace chiron::desktop {

/// Converts pixels, wheel steps and held keys into movements of an endoscope relative to its picture: the
/// pointer turns the view (right is right in the picture) or, with the right button or Shift, moves it
/// sideways; the wheel advances it.
/// Thread: GUI; the mailbox outlives it.
class EndoscopeControl final : public HandControl {
public:
    static constexpr double kMetresPerPixel = 0.00004;   ///< at 100 % scale: sideways
    static constexpr double kRadiansPerPixel = 0.0015;   ///< at 100 % scale: 300 pixels turn by 26°
    static constexpr double kMetresPerWheelStep = 0.002; ///< one notch (120 eighths of a degree)
    static constexpr double kKeyAdvance_m_per_s = 0.015; ///< the pace of a clinician
    static constexpr double kKeyShift_m_per_s = 0.006;
    static constexpr double kKeyTurn_rad_per_s = 0.35;
    static constexpr double kKeySpin_rad_per_s = 0.6;

    /// `scale` is that of the screen. `mirrored`: the workspace is left-handed; right in the picture remains
    /// right.
    EndoscopeControl(devices::EndoscopeMailbox& mailbox, double scale, bool mirrored = false)
        : m_mailbox(mailbox), m_scale(scale), m_right(mirrored ? -1.0 : 1.0) {}

    void drag(QPointF pixels, bool sideways) noexcept override;
    void wheel(int eighthsOfDegree) noexcept override;
    /// W, S, Page Up, Page Down: along the axis; arrow keys: turn, with Shift sideways; Q, E: spin.
    std::span<const int> keys() const noexcept override;
    bool keyDown(int key) override;
    bool keyUp(int key) override;
    void releaseKeys() override;
    void click() override {} ///< an endoscope marks nothing

private:
    void sendRate();
    bool holds(int key) const { return m_held.count(key) != 0; }
    double between(int minus, int plus) const {
        return (holds(plus) ? 1.0 : 0.0) - (holds(minus) ? 1.0 : 0.0);
    }

    devices::EndoscopeMailbox& m_mailbox;
    double m_scale;
    double m_right; ///< sign of the device's x direction that is right in the picture
    std::set<int> m_held;
};

} // namespace chiron::desktop
