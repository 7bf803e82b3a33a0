// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/object_handling/simulation/soft_bed.h"

#include "core/units.h"

#include <algorithm>

namespace chiron::simulation {

using core::Vec3;

namespace {

std::array<double, 3> array(const Vec3& v) noexcept {
    return {v.x(), v.y(), v.z()};
}

} // namespace

void SoftBed::begin(std::uint64_t tick) noexcept {
    m_touchers = {};
    m_touches = {};
    m_organ->restart(tick);
}

ContactPlace SoftBed::place(std::size_t who, const Vec3& p, const Vec3& v, double radius_m,
                            double reach_m) noexcept {
    Toucher& toucher = m_touchers[who];
    const Vec3 inMesh = p + Vec3(0.0, 0.0, m_lift_m);
    const MeshFoot foot = toucher.tracker.update(*m_organ, inMesh, radius_m, reach_m);
    toucher.carried += foot.surfaceMotion;
    ContactPlace place;
    place.depth_m = foot.within() ? foot.depth_m : -1.0;
    place.normal = foot.normal;
    place.depthGradient = -foot.normal;
    place.foot = foot.point;
    place.position = p - toucher.carried;
    place.velocity = v - foot.surfaceMotion / core::kTickSeconds;
    const double inFloor_m = radius_m - (p.z() - m_floor_m);
    toucher.onFloor = inFloor_m > -reach_m && inFloor_m > place.depth_m;
    if (!toucher.onFloor)
        return toucher.felt.step(place, p, foot.track == MeshTrack::acquired);
    ContactPlace floor;
    floor.depth_m = inFloor_m;
    floor.foot = Vec3(p.x(), p.y(), m_floor_m);
    floor.position = p;
    floor.velocity = v;
    return toucher.felt.step(floor, p, false);
}

void SoftBed::touched(std::size_t who, const Vec3& p, double radius_m, const ContactPlace& place,
                      const ObjectContactResponse& felt) noexcept {
    OrganTouch& touch = m_touches[who];
    touch.touching = felt.inContact && !m_touchers[who].onFloor;
    if (!touch.touching)
        return;
    const MeshFoot& foot = m_touchers[who].tracker.foot();
    touch.triangle = foot.place.triangle;
    touch.weights = array(foot.place.weights);
    touch.normal = array(place.normal);
    // The ball's nearest point
    touch.p_Tool =
        array(p + Vec3(0.0, 0.0, m_lift_m) - (radius_m - m_touchers[who].felt.less_m()) * place.normal);
    touch.stiffness_N_per_m = felt.stiffness_N_per_m;
}

void SoftBed::release(std::size_t who) noexcept {
    m_touchers[who] = Toucher();
    m_touches[who].touching = false;
}

bool SoftBed::isClear(const Vec3& p) const noexcept {
    return p.z() > m_floor_m &&
           nearestOnMesh(*m_organ, Vec3(p + Vec3(0.0, 0.0, m_lift_m))).signedDistance_m > 0.0;
}

bool SoftBed::isOutElsewhere(std::size_t who, const Vec3& p) const noexcept {
    constexpr double kSure_m = 2e-4; // closer to the sheet than this, being out counts as leaving
    const Toucher& toucher = m_touchers[who];
    const double depth_m = deepest_m(who);
    if (toucher.onFloor || !(depth_m > 0.0))
        return false;
    return (depth_m > kSure_m || toucher.tracker.foot().track == MeshTrack::followed) && isClear(p);
}

double SoftBed::restHeight_m(const core::Vec2& place_m) const noexcept {
    // Starts at the height of the organ's top. The height settles in a few rounds, because the organ is round
    // and wide.
    Vec3 at(place_m.x(), place_m.y(), 0.0);
    constexpr int kRounds = 8;
    for (int i = 0; i < kRounds; ++i) {
        const NearestOnMesh nearest = nearestOnMesh(m_organ->restMesh(), at + Vec3(0.0, 0.0, m_lift_m));
        at.z() -= nearest.signedDistance_m;
    }
    return std::max(at.z(), m_floor_m);
}

} // namespace chiron::simulation
