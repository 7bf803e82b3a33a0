// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "simulation/deformable/deformable_organ.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "simulation/geometry/mesh/mesh_tracker.h"
#include "simulation/objects/felt_place.h"
#include "simulation/objects/object_contact.h"

#include <array>
#include <cstdint>
#include <memory>

namespace chiron::simulation {

/// The organ that objects lie on: the level's mesh with its highest point at the origin of W, its upper side free, its lower one
/// anchored, simulated at 30-50 Hz beside the loop (P2, two rates) and touched by the tip and by each body as balls along the
/// blended normals (conservative: false, as all meshes; the passivity controller stands behind). It stands on a floor, the level
/// of its lowest point, so that what is thrown over its side does not fall for ever; whoever is deeper in the floor touches that.
/// Thread: make() anywhere; the rest haptic.
class SoftBed {
public:
    static constexpr std::size_t kTip = 0;       ///< who touches: the tip ...
    static constexpr std::size_t kFirstBody = 1; ///< ... and the bodies after it
    static constexpr std::size_t kTouchers = core::kMaxTools;

    /// Fails (badInput) where the mesh or the organ cannot be made.
    static core::Result<std::unique_ptr<SoftBed>> make(const ObjectHandlingParameters& parameters);

    /// Between two steps of the slow model: 1/bedRate_Hz in whole ticks.
    static std::uint64_t period_ticks(const ObjectHandlingParameters& parameters) noexcept;

    void begin(std::uint64_t tick) noexcept; ///< at rest, untouched
    /// Once a tick before place(); true when an answer of the slow model took effect.
    bool update(std::uint64_t tick, SlowUpdate when) noexcept { return m_organ->update(tick, when); }
    /// Where a ball of `radius_m` at `p`, moving with `v` (W), is against the shown surface.
    ContactPlace place(std::size_t who, const core::Vec3& p, const core::Vec3& v, double radius_m, double reach_m) noexcept;
    /// What it answered there, for the slow model.
    void touched(std::size_t who, const core::Vec3& p, double radius_m, const ContactPlace& place,
                 const ObjectContactResponse& felt) noexcept;
    void release(std::size_t who) noexcept;
    /// In free air: over the floor and out of the organ as it is shown.
    bool isClear(const core::Vec3& p) const noexcept;
    /// Whether somebody of no size has come out of the organ elsewhere than he went in, by the last place().
    bool isOutElsewhere(std::size_t who, const core::Vec3& p) const noexcept;
    /// Once a tick after the contacts: asks the slow model when it is time.
    void ask(std::uint64_t tick) noexcept { m_organ->ask(tick, m_touches); }

    /// Height of the rest surface over (x, y), m in W; the floor's beyond it.
    double restHeight_m(const core::Vec2& place_m) const noexcept;
    double floorHeight_m() const noexcept { return m_floor_m; } ///< z of the floor in W
    double reach_m() const noexcept { return m_reach_m; }       ///< half the narrower of its widths along x and y
    DeformableOrgan& organ() noexcept { return *m_organ; }
    const DeformableOrgan& organ() const noexcept { return *m_organ; }

private:
    SoftBed() = default;

    struct Toucher {
        MeshTracker tracker;
        FeltPlace felt;
        core::Vec3 carried = core::Vec3::Zero(); ///< how far the touched places have moved with the surface, m
        bool onFloor = false;                    ///< the floor is what it touches: the organ hears nothing of it
    };

    std::unique_ptr<DeformableOrgan> m_organ;
    double m_lift_m = 0.0; ///< of the mesh's frame: z_W = z - m_lift_m
    double m_floor_m = 0.0;
    double m_reach_m = 0.0;
    std::array<Toucher, kTouchers> m_touchers{};
    OrganTouches m_touches{};
};

} // namespace chiron::simulation
