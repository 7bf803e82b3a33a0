// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/object_handling/simulation/handling_world.h"

#include "core/session_state.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

using core::Vec3;
namespace bits = core::event_bits;

namespace {

constexpr double kT = core::kTickSeconds;
/// Stiffness with which the rim of the field lets objects that were pushed away roll back, so that a trial
/// can go on (assumption). It acts on free objects alone, never on a tool or on what a tool holds, and is no
/// part of the energy balance (docs/exercises.md, Object handling).
constexpr double kRim_N_per_m = 100.0;
/// A free body slower than this lies still; its height and energy there are the reference for lifting
/// (assumption).
constexpr double kStill_m_per_s = 0.002;
/// Closer to a ball's centre than this share of its radius, the foot does not move any faster: the law is not
/// defined there.
constexpr double kInnermost = 0.1;
/// A tip that is deeper in a ball than this share of its radius pierces it: closer to the centre the force
/// would turn faster than the tip moves (assumption, as for the dome in exercises/sphere_apex).
constexpr double kPiercedShare = 0.6;

Vec3 rimForce(const LooseBody& body, double rim_m) noexcept {
    const double r = std::hypot(body.p_W.x(), body.p_W.y());
    if (r <= rim_m)
        return Vec3::Zero();
    const double f = kRim_N_per_m * (rim_m - r) / r;
    return {f * body.p_W.x(), f * body.p_W.y(), 0.0};
}

} // namespace

void HandlingWorld::begin(const ObjectHandlingTrial& trial) noexcept {
    clear();
    m_count = static_cast<std::size_t>(trial.objects);
    for (std::size_t i = 0; i < m_count; ++i) {
        Body& body = m_bodies[i];
        const double height_m = m_soft != nullptr ? m_soft->restHeight_m(trial.place_m[i]) : 0.0;
        body.it.lieDown(trial.place_m[i], height_m, m_parameters.radius_m, trial.mass_kg[i], m_bodyBed);
        body.tip.reset();
        body.yield = ContactYield(m_parameters.yield);
        // A body that appears around the tip is touched only after the tip has left it
        body.inside = body.embraced = true;
        body.airborne = body.dropCounts = false;
    }
}

void HandlingWorld::clear() noexcept {
    m_count = 0;
    m_tipOnBed.reset();
    m_bedYield = ContactYield(m_parameters.yield);
    m_latch.reset();
    m_slide.reset();
    m_held = kNone;
    m_squeeze = Squeeze{};
    m_damageArmed = true;
}

HandlingAnswer HandlingWorld::step(const HandlingTool& tool) noexcept {
    HandlingAnswer answer;
    answer.surfacePoint = tool.p_W;
    m_budget = DampingBudget(tool.mostDamping_Ns_per_m);
    if (m_held != kNone && tool.present) {
        LooseBody& body = m_bodies[static_cast<std::size_t>(m_held)].it;
        body.p_W = tool.p_W + m_grip_m + m_slide.offset();
        body.v_W = tool.v_W + m_slide.velocity();
    }
    updateGrip(tool, answer);
    for (std::size_t i = 0; i < m_count; ++i) {
        Body& body = m_bodies[i];
        body.load = Vec3::Zero();
        body.touched = false;
        body.tipEnergy_J = 0.0;
        layOnBed(i);
        if (tool.present && !isHeld(i))
            touchBody(body, tool, answer);
    }
    if (tool.present)
        touchBed(tool, answer);
    else if (m_soft != nullptr)
        m_soft->release(SoftBed::kTip);
    pushApart(answer);
    carry(answer);
    countEnergy(answer);
    moveBodies(answer);
    answer.damping_Ns_per_m = m_budget.used_Ns_per_m();
    return answer;
}

/// Flags the answer if one of its contacts is deeper than the laws have been checked.
void HandlingWorld::checkRange(double depth_m, HandlingAnswer& answer) noexcept {
    if (depth_m > kCheckedContactDepth_m)
        answer.contact |= core::contact_bits::kBeyondChecked;
}

bool HandlingWorld::tipTouches(Body& body, double depth_m, const HandlingTool& tool) const noexcept {
    const bool inside = depth_m > -m_object.reach_m();
    if (!inside)
        body.embraced = false;
    else if (!body.inside) // it has just come in: either between open jaws, or touched by the tip
        body.embraced = tool.opening_m > 2.0 * body.it.radius_m();
    body.inside = inside;
    return !body.embraced;
}

void HandlingWorld::touchBody(Body& body, const HandlingTool& tool, HandlingAnswer& answer) noexcept {
    const Vec3 away = tool.p_W - body.it.p_W;
    const double distance = away.norm();
    const double radius = body.it.radius_m();
    ContactPlace place;
    place.depth_m = radius - distance;
    if (!tipTouches(body, place.depth_m, tool)) {
        body.tip.reset();
        body.yield.reset();
        return;
    }
    place.normal = distance > 0.0 ? Vec3(away / distance) : Vec3(Vec3::UnitZ());
    place.depthGradient = -place.normal;
    place.foot = radius * place.normal;
    place.footScale = radius / std::max(distance, kInnermost * radius);
    place.position = away;
    place.velocity = tool.v_W - body.it.v_W;
    place.mostDamping_Ns_per_m = m_budget.left_Ns_per_m();
    ObjectContactResponse touch = m_object.respond(place, kT, body.tip);
    const bool pierced = body.yield.everYields() && place.depth_m > kPiercedShare * radius;
    const double holds = body.yield.step(touch.force.norm(), !touch.inContact, pierced, kT);
    answer.contact |= body.yield.bits();
    if (touch.inContact && holds > 0.0)
        checkRange(place.depth_m, answer);
    scale(touch, holds);
    body.tipEnergy_J = touch.energy_J;
    if (!touch.inContact || holds == 0.0)
        return;
    body.touched = true;
    m_budget.spend(touch.damping_Ns_per_m);
    body.load -= touch.force;
    answer.force += touch.force;
    // A ball's force turns with its nearest point
    const double turning = place.depth_m / std::max(distance, (1.0 - kPiercedShare) * radius);
    // Simultaneous contacts add up
    answer.stiffness_N_per_m += touch.stiffness_N_per_m * std::max(1.0, turning);
    answer.surfacePoint = tool.p_W + std::max(0.0, place.depth_m) * place.normal;
    answer.touching = true;
}

ContactPlace HandlingWorld::bedPlace(std::size_t who, const Vec3& p, const Vec3& v, double radius_m,
                                     double reach_m) noexcept {
    if (m_soft != nullptr)
        return m_soft->place(who, p, v, radius_m, reach_m);
    ContactPlace place;
    place.depth_m = radius_m - p.z();
    place.foot = Vec3(p.x(), p.y(), 0.0);
    place.position = p;
    place.velocity = v;
    return place;
}

void HandlingWorld::layOnBed(std::size_t i) noexcept {
    LooseBody& body = m_bodies[i].it;
    const std::size_t who = SoftBed::kFirstBody + i;
    ContactPlace place = bedPlace(who, body.p_W, body.v_W, body.radius_m(), 0.0);
    if (isHeld(i)) // it moves with the tool
        place.mostDamping_Ns_per_m = m_budget.left_Ns_per_m();
    const ObjectContactResponse& felt = body.pressBed(m_bodyBed, place);
    if (isHeld(i))
        m_budget.spend(felt.damping_Ns_per_m);
    if (m_soft != nullptr)
        m_soft->touched(who, body.p_W, body.radius_m(), place, felt);
}

void HandlingWorld::touchBed(const HandlingTool& tool, HandlingAnswer& answer) noexcept {
    const bool clear =
        m_soft != nullptr ? m_bedYield.gone() && m_soft->isClear(tool.p_W) : tool.p_W.z() > m_bed.reach_m();
    if (m_bedYield.gone() && clear) { // out again: whatever it touches next is whole
        m_bedYield.reset();
        m_tipOnBed.reset();
        if (m_soft != nullptr)
            m_soft->release(SoftBed::kTip);
    }
    ContactPlace place = bedPlace(SoftBed::kTip, tool.p_W, tool.v_W, 0.0, m_bed.reach_m());
    place.mostDamping_Ns_per_m = m_budget.left_Ns_per_m();
    ObjectContactResponse touch = m_bed.respond(place, kT, m_tipOnBed);
    const bool out = m_soft != nullptr && touch.inContact && m_soft->isOutElsewhere(SoftBed::kTip, tool.p_W);
    const double holds =
        m_bedYield.step(touch.force.norm(), !touch.inContact && !m_bedYield.through(), out, kT);
    answer.contact |= m_bedYield.bits();
    if (touch.inContact && holds > 0.0)
        checkRange(m_soft != nullptr ? m_soft->deepest_m(SoftBed::kTip) : place.depth_m, answer);
    scale(touch, holds);
    touch.inContact = touch.inContact && holds > 0.0;
    if (m_soft != nullptr)
        m_soft->touched(SoftBed::kTip, tool.p_W, 0.0, place, touch);
    answer.energy_J += touch.energy_J;
    if (!touch.inContact)
        return;
    const double depth = std::max(0.0, place.depth_m);
    m_budget.spend(touch.damping_Ns_per_m);
    answer.force += touch.force;
    answer.stiffness_N_per_m += touch.stiffness_N_per_m;
    answer.bedDepth_m = depth;
    answer.surfacePoint.z() = std::max(answer.surfacePoint.z(), tool.p_W.z() + depth * place.normal.z());
    answer.touching = true;
}

void HandlingWorld::pushApart(HandlingAnswer& answer) noexcept {
    // Both bodies are soft: two springs k in series give k/2 over the whole overlap.
    const double stiffness = 0.5 * m_parameters.object.stiffness_N_per_m;
    for (std::size_t k = 1; k < m_count; ++k)
        for (std::size_t i = 0; i < k; ++i) {
            Body& one = m_bodies[i];
            Body& other = m_bodies[k];
            const Vec3 apart = other.it.p_W - one.it.p_W;
            const double distance = apart.norm();
            const double overlap = one.it.radius_m() + other.it.radius_m() - distance;
            if (overlap <= 0.0 || distance <= 0.0)
                continue;
            const Vec3 push = (stiffness * overlap / distance) * apart;
            other.load += push;
            one.load -= push;
            if (isHeld(i) || isHeld(k)) { // the hand feels it through the held object
                answer.stiffness_N_per_m += stiffness;
                checkRange(0.5 * overlap, answer); // half of it in each of the two
            }
            if (isHeld(i) || isHeld(k) || one.touched || other.touched)
                answer.energy_J += 0.5 * stiffness * overlap * overlap;
        }
}

void HandlingWorld::carry(HandlingAnswer& answer) noexcept {
    if (m_held == kNone)
        return;
    Body& body = m_bodies[static_cast<std::size_t>(m_held)];
    const Vec3 load = body.load + body.it.heldForce();
    m_budget.spend(body.it.rolling_Ns_per_m());
    answer.force -=
        m_slide.step(load, gripLimit_N(m_object.friction(), m_squeeze.force_N), body.it.mass_kg(), kT);
    answer.stiffness_N_per_m += body.it.bedStiffness_N_per_m();
    checkRange(body.it.bedDepth_m(), answer);
    answer.touching = true;
}

void HandlingWorld::countEnergy(HandlingAnswer& answer) noexcept {
    for (std::size_t i = 0; i < m_count; ++i) {
        const Body& body = m_bodies[i];
        answer.bedDepth_m = std::max(answer.bedDepth_m, body.it.bedDepth_m());
        answer.energy_J += body.tipEnergy_J;
        if (isHeld(i))
            answer.energy_J += body.it.storedEnergy_J();
        else if (body.touched)
            answer.energy_J += body.it.storedEnergy_J() + body.it.motionEnergy_J();
    }
    if (m_soft == nullptr)
        return;
    const double organ_J = m_soft->organ().elasticEnergy_J();
    if (answer.touching) // the organ's energy beyond that due to the lying bodies
        answer.energy_J += std::max(0.0, organ_J - m_organRest_J);
    else
        m_organRest_J = organ_J;
}

void HandlingWorld::moveBodies(HandlingAnswer& answer) noexcept {
    const double rim = m_parameters.placesRadius_m + kRimBeyondPlaces_m;
    for (std::size_t i = 0; i < m_count; ++i) {
        Body& body = m_bodies[i];
        const bool inAir = !body.it.onBed();
        if (body.airborne && !inAir && body.dropCounts && !isHeld(i)) {
            body.dropCounts = false;
            if (-body.it.v_W.z() > m_parameters.dropSpeed_m_per_s)
                answer.events |= bits::kSlipped;
        }
        body.airborne = inAir;
        if (!isHeld(i) && !body.touched && !inAir &&
            body.it.v_W.squaredNorm() < kStill_m_per_s * kStill_m_per_s) {
            body.it.lieStill();
            body.dropCounts = false;
        }
        if (!isHeld(i))
            body.it.moveFreely(body.load + rimForce(body.it, rim));
    }
}

} // namespace chiron::simulation
