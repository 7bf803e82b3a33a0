// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "devices/api/workspace_map.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/palpation/operators/finger_order.h"
#include "modules/exercises/palpation/operators/palpation_operator_settings.h"
#include "modules/exercises/palpation/operators/press.h"
#include "operators/hand/instrument_feel.h"
#include "simulation/palpation/tissue_surface.h"

#include <cstdint>

namespace chiron::operators {

/// Converts what really happens to one finger while it attends to a press into what is felt: the force along
/// the normal of the seen surface, how far the finger has moved into the drawn surface since it touched, and
/// the lean. On a fingertip platform (HandPerception::fingertip) these come from what the platform does to
/// the pad, whose force is entirely the tissue's. For an instrument that `hand` holds, they come from the
/// force on the hand: the tip is displaced from the hand by the give of the grip (InstrumentFeel), and it
/// touches where it is seen to touch, because its own friction and mass are felt earlier. Seeded.
/// Thread: haptic; allocates nothing.
class FingerSenses {
public:
    FingerSenses(const PalpationPerceptionSettings& settings, const mechanisms::HandParameters& hand,
                 const devices::WorkspaceMapping& place, std::uint64_t seed,
                 const simulation::SurfaceShape& drawn = {});
    /// Call in every tick. Returns true when a press is over and press() holds what was felt.
    bool feel(const mechanisms::HandPerception& real, const FingerOrder& order) noexcept;
    const Press& press() const noexcept { return m_press; }
    bool touching() const noexcept { return m_touching; }

private:
    struct Touch {
        double force_N = 0.0;
        core::Vec3 lean_rad = core::Vec3::Zero(); ///< W, in the plane of the surface
    };
    struct Seen {
        double height_m = 0.0; ///< above the surface; < 0 in the tissue
        core::Vec3 foot_W = core::Vec3::Zero();
    };
    Seen seenAt(const core::Vec3& place_W, const FingerOrder& order) const noexcept;
    Touch padTouch(const mechanisms::HandPerception& real, const core::Vec3& normal_W) const noexcept;
    Touch heldTouch(const core::Vec3& force_W, const core::Vec3& normal_W) const noexcept;
    void judge(bool platform, int pressure) noexcept;

    PalpationPerceptionSettings m_settings;
    devices::WorkspaceMap m_map;
    simulation::TissueSurface m_surface; ///< as drawn
    core::Random m_random;
    InstrumentFeel m_instrument;
    bool m_touching = false;
    double m_touchedAt_m = 0.0; ///< height above the surface
    int m_attended = 0;         ///< number of the last press that it has reported
    int m_ticks = 0;            ///< ticks of attention in the present press
    int m_touchedTicks = 0;
    double m_force_N = 0.0, m_depth_m = 0.0; ///< sums over the ticks of attention
    core::Vec3 m_lean_rad = core::Vec3::Zero();
    core::Vec3 m_place_W = core::Vec3::Zero();
    Press m_press;
};

} // namespace chiron::operators
