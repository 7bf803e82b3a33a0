// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/objects/object_contact.h"

#include <algorithm>

namespace chiron::simulation {

/// What is felt of a place whose geometry may jump or turn faster than the tool goes: a mesh's sheet that is left for another one, a
/// surface that folds or moves under the tool, a floor that is the deeper one all of a sudden.
///
/// With s = d n, the way out to the surface, and w, how far the tool went since the tick before:
///   ‖s(t) − s(t−1)‖ ≤ g w + c
/// so that an elastic force k s changes by at most k (g w + c) in a tick, whatever the geometry does. And a tool that is found deep behind a
/// sheet that it has not gone in by is pushed only by what it goes deeper from there:
///   d' = d − o,  o = d − ‖s(t−1)‖ − (g w + c) ≥ 0 when the sheet is found; never more than d later
/// so that it feels nothing all at once, is let out freely, and meets the sheet itself as soon as it has been out.
/// A tool that is seen for the first time, or has jumped, is taken as it is: an object that appears is armed (models.md §5).
/// One object a tool and body. Fixed size; thread: haptic.
class FeltPlace {
public:
    static constexpr double kTeleport_m = 0.020; ///< in one tick: no motion (models.md §5)
    static constexpr double kCatchUp_m = 5e-5;   ///< c: 0.03 N at 600 N/m, so that a place that lags is where it should be in a twentieth of a second for 2 mm (assumption)

    /// The place as it is felt. `p` m: the tool, in the frame of the place; `found`: this sheet was not touched at the tick before;
    /// `perWay` g ≥ 1: how much faster than the tool the way out may change (1 on a plane).
    ContactPlace step(ContactPlace place, const core::Vec3& p, bool found, double perWay = 1.0) noexcept {
        const double moved = (p - m_p).norm();
        const bool known = m_known && !(moved > kTeleport_m);
        m_p = p;
        m_known = true;
        m_geometric_m = place.depth_m;
        if (!known) {
            m_left_m = 0.0;
        } else {
            const double most = perWay * moved + kCatchUp_m;
            if (found || !m_wasIn)
                m_left_m = place.depth_m - m_out.norm() - most;
            m_left_m = std::clamp(m_left_m, 0.0, std::max(0.0, place.depth_m));
            place.depth_m -= m_left_m;
            keepUp(place, most);
        }
        m_wasIn = m_geometric_m > 0.0;
        m_out = place.depth_m > 0.0 ? core::Vec3(place.depth_m * place.normal) : core::Vec3(core::Vec3::Zero());
        m_felt_m = place.depth_m;
        return place;
    }

    double geometric_m() const noexcept { return m_geometric_m; } ///< depth as the geometry has it, signed
    double felt_m() const noexcept { return m_felt_m; }           ///< and as it is felt
    /// How much less deep than that it is felt (negative: deeper, where the surface went away faster): for who is told where the tool is.
    double less_m() const noexcept { return m_felt_m > 0.0 ? m_geometric_m - m_felt_m : 0.0; }
    void reset() noexcept { *this = FeltPlace(); }

private:
    void keepUp(ContactPlace& place, double most_m) const noexcept {
        const core::Vec3 wanted = place.depth_m > 0.0 ? core::Vec3(place.depth_m * place.normal) : core::Vec3(core::Vec3::Zero());
        const core::Vec3 change = wanted - m_out;
        const double length2 = change.squaredNorm();
        if (!(length2 > most_m * most_m))
            return;
        const core::Vec3 out = m_out + change * (most_m / std::sqrt(length2));
        const double depth_m = out.norm();
        if (!(depth_m > 0.0))
            return;
        place.depth_m = depth_m;
        place.normal = out / depth_m;
        place.depthGradient = -place.normal;
    }

    core::Vec3 m_p = core::Vec3::Zero();
    core::Vec3 m_out = core::Vec3::Zero(); ///< s as it was felt
    double m_geometric_m = -1.0;
    double m_felt_m = -1.0;
    double m_left_m = 0.0; ///< o
    bool m_known = false;
    bool m_wasIn = false;
};

} // namespace chiron::simulation
