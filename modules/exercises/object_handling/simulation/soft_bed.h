// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "simulation/deformable/deformable_organ.h"
#include "simulation/geometry/mesh/mesh_tracker.h"
#include "simulation/objects/felt_place.h"
#include "simulation/objects/object_contact.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

namespace chiron::simulation {

/// The organ on which objects lie. It is the level's mesh with its highest point at the origin of W, free on
/// its upper side and anchored on its lower side, and simulated at 30-50 Hz beside the loop (P2, two rates).
/// The tip and each body touch it as balls along the blended normals (conservative: false, as for all meshes;
/// the passivity controller limits it). It stands on a floor at the level of its lowest point, so that an
/// object thrown over its side does not fall for ever; a toucher that is deeper in the floor than in the
/// organ touches the floor.
/// Thread: any for make(); haptic for the rest.
class SoftBed {
public:
    static constexpr std::size_t kTip = 0;       ///< touchers: the tip ...
    static constexpr std::size_t kFirstBody = 1; ///< ... and the bodies after it
    static constexpr std::size_t kTouchers = core::kMaxTools;

    /// Errors: badInput where the mesh or the organ cannot be made.
    static core::Result<std::unique_ptr<SoftBed>> make(const ObjectHandlingParameters& parameters);

    /// Time between two steps of the slow model: 1/bedRate_Hz in whole ticks.
    static std::uint64_t period_ticks(const ObjectHandlingParameters& parameters) noexcept;

    void begin(std::uint64_t tick) noexcept; ///< puts the organ at rest, untouched
    /// Call once per tick before place(). Returns true when an answer of the slow model took effect.
    bool update(std::uint64_t tick, SlowUpdate when) noexcept { return m_organ->update(tick, when); }
    /// Contact of a ball of `radius_m` at `p`, moving with `v` (W), with the shown surface.
    ContactPlace place(std::size_t who, const core::Vec3& p, const core::Vec3& v, double radius_m,
                       double reach_m) noexcept;
    /// Records the response at that contact, for the slow model.
    void touched(std::size_t who, const core::Vec3& p, double radius_m, const ContactPlace& place,
                 const ObjectContactResponse& felt) noexcept;
    void release(std::size_t who) noexcept;
    /// Says whether p is in free air: above the floor and outside the organ as it is shown.
    bool isClear(const core::Vec3& p) const noexcept;
    /// Says whether a toucher of radius 0 has come out of the organ elsewhere than it went in, according to
    /// the last place().
    bool isOutElsewhere(std::size_t who, const core::Vec3& p) const noexcept;
    /// How deep a toucher is, by the geometry or as it is felt, whichever is more, according to the last
    /// place().
    double deepest_m(std::size_t who) const noexcept {
        return std::max(m_touchers[who].felt.geometric_m(), m_touchers[who].felt.felt_m());
    }
    /// Call once per tick after the contacts: sends a request to the slow model when it is time.
    void ask(std::uint64_t tick) noexcept { m_organ->ask(tick, m_touches); }

    /// Height of the rest surface over (x, y), m in W; beyond the surface, that of the floor.
    double restHeight_m(const core::Vec2& place_m) const noexcept;
    double floorHeight_m() const noexcept { return m_floor_m; } ///< z of the floor in W
    /// Half of the smaller of its widths along x and y.
    double reach_m() const noexcept { return m_reach_m; }
    DeformableOrgan& organ() noexcept { return *m_organ; }
    const DeformableOrgan& organ() const noexcept { return *m_organ; }

private:
    SoftBed() = default;

    struct Toucher {
        MeshTracker tracker;
        FeltPlace felt;
        /// How far the touched places have moved with the surface so far, m.
        core::Vec3 carried = core::Vec3::Zero();
        bool onFloor = false; ///< it touches the floor, and the organ is not told about it
    };

    std::unique_ptr<DeformableOrgan> m_organ;
    double m_lift_m = 0.0; ///< height of the mesh's frame: z_W = z - m_lift_m
    double m_floor_m = 0.0;
    double m_reach_m = 0.0;
    std::array<Toucher, kTouchers> m_touchers{};
    OrganTouches m_touches{};
};

} // namespace chiron::simulation
