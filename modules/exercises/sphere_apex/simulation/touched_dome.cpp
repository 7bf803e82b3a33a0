// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/simulation/touched_dome.h"

#include "core/units.h"

#include <cmath>

namespace chiron::simulation {

namespace {

core::Vec3 turned(double cosine, double sine, const core::Vec3& v) noexcept {
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y(), v.z()};
}

std::array<double, 3> array(const core::Vec3& v) noexcept {
    return {v.x(), v.y(), v.z()};
}

ContactPlace placeOnPlane(const core::Vec3& p, const core::Vec3& v) noexcept {
    ContactPlace place;
    place.depth_m = -p.z();
    place.foot = core::Vec3(p.x(), p.y(), 0.0);
    place.velocity = v;
    return place;
}

} // namespace

void TouchedDome::begin(std::size_t trial, std::uint64_t tick) noexcept {
    m_trial = trial;
    m_tools = {};
    for (Tool& tool : m_tools)
        tool.yield = ContactYield(m_yield);
    m_touches = {};
    if (m_organ)
        m_organ->restart(tick);
}

bool TouchedDome::update(std::uint64_t tick, SlowUpdate when) noexcept {
    return m_organ && m_organ->update(tick, when);
}

void TouchedDome::ask(std::uint64_t tick) noexcept {
    if (m_organ)
        m_organ->ask(tick, m_touches);
}

void TouchedDome::release(std::size_t tool) noexcept {
    if (!m_tools[tool].used)
        return;
    m_tools[tool] = Tool();
    m_tools[tool].yield = ContactYield(m_yield);
    m_touches[tool].touching = false;
}

core::Vec3 TouchedDome::toMesh(const Place& place, const core::Vec3& p_W) const noexcept {
    return turned(place.cosine, -place.sine,
                  p_W - core::Vec3(place.centre_m.x(), place.centre_m.y(), m_planeHeight_m));
}

template <class Surface>
ContactPlace TouchedDome::placeOn(const Surface& surface, Tool& tool, const core::Vec3& p,
                                  const core::Vec3& v, double reach_m) noexcept {
    const double across = std::hypot(p.x(), p.y());
    ContactPlace plane = placeOnPlane(p, v);
    const bool wasOnPlane = tool.onPlane;
    // Under the dome, deeper than where it gives way, the tool is still on the plane that it went into,
    // because it entered no sheet of the dome.
    tool.onPlane = across >= m_blendTo_m || (wasOnPlane && tool.yield.everYields() && p.z() < -m_deepest_m);
    plane.position = p - tool.carried;
    if (tool.onPlane)
        return tool.felt.step(plane, p, false, 1.0 + turnsPerWay(tool.felt.felt_m()));
    // It comes in below the plane: search from above, or the plate's other side would be the nearest
    if (wasOnPlane) {
        tool.tracker.reset();
        tool.tracker.update(surface, core::Vec3(p.x(), p.y(), std::max(p.z(), 0.0)), 0.0, reach_m);
    }
    const MeshFoot foot = tool.tracker.update(surface, p, 0.0, reach_m);
    tool.carried += foot.surfaceMotion;
    ContactPlace place;
    place.depth_m = foot.within() ? foot.depth_m : -1.0;
    place.normal = foot.normal;
    place.foot = foot.point;
    place.position = p - tool.carried;
    place.velocity = v - foot.surfaceMotion / core::kTickSeconds;
    if (across > m_blendFrom_m && foot.within()) {
        const double w = (across - m_blendFrom_m) / (m_blendTo_m - m_blendFrom_m);
        const double s = w * w * (3.0 - 2.0 * w);
        place.depth_m += s * (plane.depth_m - place.depth_m);
        place.normal = ((1.0 - s) * place.normal + s * plane.normal).normalized();
        place.foot += s * (plane.foot - place.foot);
    }
    place.depthGradient = -place.normal;
    return tool.felt.step(place, p, !wasOnPlane && foot.track == MeshTrack::acquired,
                          1.0 + turnsPerWay(tool.felt.felt_m()));
}

/// The force turns with the ball's nearest point by 1/(R − d) per distance moved, and between facets by up to
/// twice that.
double TouchedDome::turnsPerWay(double depth_m) const noexcept {
    return 2.0 * std::max(0.0, depth_m) / std::max(m_radius_m - depth_m, m_radius_m - m_deepest_m);
}

/// Says whether p is in free air: above the plane and outside the dome.
bool TouchedDome::isClear(const core::Vec3& p) const noexcept {
    if (!(p.z() > 0.0))
        return false;
    if (std::hypot(p.x(), p.y()) >= m_blendTo_m)
        return true;
    return (m_organ ? nearestOnMesh(*m_organ, p) : nearestOnMesh(m_mesh, p)).signedDistance_m > 0.0;
}

/// Says whether the tool has come out on another side than it went in by, or is deeper than the dome's law is
/// defined.
bool TouchedDome::isBreached(const Tool& tool, const core::Vec3& p) const noexcept {
    constexpr double kSure_m = 2e-4; // closer to the sheet than this, being out counts as leaving
    const double depth_m = std::max(tool.felt.geometric_m(), tool.felt.felt_m());
    if (!(depth_m > 0.0))
        return false;
    if (tool.yield.everYields() && depth_m > m_deepest_m)
        return true;
    const bool elsewhere =
        !tool.onPlane && (depth_m > kSure_m || tool.tracker.foot().track == MeshTrack::followed);
    return elsewhere && isClear(p);
}

ContactResponse TouchedDome::respond(std::size_t tool, const core::Vec3& p_WT, const core::Vec3& v_WT,
                                     double mostDamping_Ns_per_m) noexcept {
    const Place& at = m_places[m_trial];
    Tool& state = m_tools[tool];
    state.used = true;
    const core::Vec3 p = toMesh(at, p_WT);
    const core::Vec3 v = turned(at.cosine, -at.sine, v_WT);
    const double reach = at.contact.reach_m();
    if (state.yield.gone() && isClear(p)) { // out again: whatever it touches next is whole
        state = Tool();
        state.used = true;
        state.yield = ContactYield(m_yield);
    }
    ContactPlace place =
        m_organ ? placeOn(*m_organ, state, p, v, reach) : placeOn(m_mesh, state, p, v, reach);
    place.mostDamping_Ns_per_m = mostDamping_Ns_per_m;
    const ObjectContactResponse felt = at.contact.respond(place, core::kTickSeconds, state.object);

    const bool outside = !felt.inContact && !state.yield.through();
    const double holds =
        state.yield.step(felt.force.norm(), outside, isBreached(state, p), core::kTickSeconds);

    ContactResponse response;
    response.surfacePoint = p_WT;
    response.bits = state.yield.bits();
    if (std::max(felt.depth_m, state.felt.geometric_m()) > kCheckedContactDepth_m)
        response.bits |= core::contact_bits::kBeyondChecked;
    OrganTouch& touch = m_touches[tool];
    touch.touching = felt.inContact && !state.onPlane && holds > 0.0;
    if (!felt.inContact)
        return response;
    touch.triangle = state.tracker.foot().place.triangle;
    touch.weights = array(state.tracker.foot().place.weights);
    touch.normal = array(place.normal);
    touch.p_Tool = array(core::Vec3(p + state.felt.less_m() * place.normal));
    touch.stiffness_N_per_m = holds * felt.stiffness_N_per_m;
    response.inContact = true;
    response.force = turned(at.cosine, at.sine, felt.force);
    response.normal = turned(at.cosine, at.sine, felt.normal);
    response.depth_m = felt.depth_m;
    response.normalForce_N = felt.normalForce_N;
    response.energy_J = felt.energy_J;
    response.damping_Ns_per_m = felt.damping_Ns_per_m;
    const double perDepth_N_per_m = felt.depth_m > 0.0 ? felt.force.norm() / felt.depth_m : 0.0;
    response.stiffness_N_per_m = felt.stiffness_N_per_m + perDepth_N_per_m * turnsPerWay(felt.depth_m);
    if (holds > 0.0)
        response.surfacePoint = p_WT + felt.depth_m * turned(at.cosine, at.sine, place.normal);
    response.inContact = holds > 0.0;
    scale(response, holds);
    return response;
}

core::Vec3 TouchedDome::restPoint(std::size_t trial, const core::Vec3& p_WT) const noexcept {
    const Place& at = m_places[trial];
    const core::Vec3 p = toMesh(at, p_WT);
    if (std::hypot(p.x(), p.y()) >= m_blendTo_m)
        return p.z() < 0.0 ? core::Vec3(p_WT.x(), p_WT.y(), m_planeHeight_m) : p_WT;
    const NearestOnMesh nearest = nearestOnMesh(m_mesh, p);
    if (nearest.signedDistance_m >= 0.0)
        return p_WT;
    return turned(at.cosine, at.sine, nearest.point) +
           core::Vec3(at.centre_m.x(), at.centre_m.y(), m_planeHeight_m);
}

} // namespace chiron::simulation
