// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_strategy.h"

namespace chiron::station {

/// A hand that holds the tool where it finds it. It may move it to and fro in the plane x = 0, which every
/// mechanism can reach, or press: after a while it goes down within a second, and circles there.
class HoldingHand final : public mechanisms::HandStrategy {
public:
    struct Motion {
        double amplitude_m = 0.0; ///< 0: keeps still
        double frequency_Hz = 0.5;
        double depth_m = 0.0; ///< how far down it presses; 0: not at all
        double after_s = 3.0; ///< when it begins to press
    };
    explicit HoldingHand(Motion motion);
    ~HoldingHand() override;
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override;

private:
    Motion m_motion;
    bool m_holds = false;
    mechanisms::HandIntention m_at;
};

} // namespace chiron::station
