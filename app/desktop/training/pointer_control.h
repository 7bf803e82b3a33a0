// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/hand_control.h"
#include "devices/api/pointer_mailbox.h"

#include <set>

namespace chiron::desktop {

/// Converts pixels, wheel steps and held keys into metres of hand movement in D (x to the right, y away from
/// the person, z up).
/// Thread: GUI; the mailbox outlives it.
class PointerControl final : public HandControl {
public:
    static constexpr double kMetresPerPixel = 0.0001; ///< at 100 % scale: 650 pixels are the field's radius
    static constexpr double kMetresPerWheelStep = 0.002; ///< one notch (120 eighths of a degree)
    static constexpr double kKeySpeed_m_per_s = 0.030;

    /// The vertical speed of wheel and keys. The horizontal speed is kKeySpeed_m_per_s.
    struct Lift {
        double wheelStep_m = kMetresPerWheelStep;
        double keySpeed_m_per_s = kKeySpeed_m_per_s;
        bool operator==(const Lift&) const = default;
    };

    /// `scale` is that of the screen: a scaled-up picture needs the same hand movement as a small one.
    /// `mirrored`: the workspace is left-handed; right on the screen remains right in the scene.
    PointerControl(devices::PointerMailbox& mailbox, double scale, bool mirrored = false)
        : PointerControl(mailbox, scale, mirrored, Lift{}) {}
    PointerControl(devices::PointerMailbox& mailbox, double scale, bool mirrored, Lift lift)
        : m_mailbox(mailbox), m_scale(scale), m_right(mirrored ? -1.0 : 1.0), m_lift(lift) {}

    /// The pointer moved by this many pixels (y down): horizontally in the scene, or vertically while
    /// `lifting`.
    void drag(QPointF pixels, bool lifting) noexcept override;
    void wheel(int eighthsOfDegree) noexcept override;
    std::span<const int> keys() const noexcept override; ///< arrow keys and PageUp/PageDown
    bool keyDown(int key) override;
    bool keyUp(int key) override;
    void releaseKeys() override;
    void click() override;   ///< "Here it is": marks
    void setLift(Lift lift); ///< takes effect at once, also for a held key

private:
    void sendRate();

    devices::PointerMailbox& m_mailbox;
    double m_scale;
    double m_right; ///< sign of the x direction in D that is right in W
    Lift m_lift;
    std::set<int> m_held;
};

} // namespace chiron::desktop
