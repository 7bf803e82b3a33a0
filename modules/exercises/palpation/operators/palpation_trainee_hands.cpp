// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/palpation/operators/palpation_trainee.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::Vec2;
using core::Vec3;

namespace {
// Habits that all operators share: assumptions.
constexpr double kAway_m = 0.020;    ///< height above the tissue while there is nothing to do
constexpr double kFarJump_m = 0.015; ///< over an organ, the hand rises first for a movement this long
constexpr double kNear_m = 0.0012;   ///< tolerance on the way
constexpr double kDown_m = 0.0004;   ///< tolerance at the wanted depth
/// It still attends to presses up to this distance outside the search area.
constexpr double kBeside_m = 0.006;
constexpr double kSettle_s = 0.10; ///< time for the arm to settle before a press counts
constexpr double kDeepest_m = 0.016;
} // namespace

std::size_t PalpationTrainee::handFor(const Vec2& place_m) const noexcept {
    if (hands() < 2)
        return 0;
    return (place_m.x() >= 0.0) == m_rightFirst ? 0 : 1;
}

SearchShare PalpationTrainee::shareOf(std::size_t hand) const noexcept {
    SearchShare share{-m_briefing.areaHalf_m, m_briefing.areaHalf_m, m_briefing.fingers,
                      m_briefing.fingerSpacing_m};
    if (hands() < 2)
        return share;
    const bool right = (hand == 0) == m_rightFirst;
    (right ? share.low_m : share.high_m).x() = 0.0;
    return share;
}

bool PalpationTrainee::inside(const Vec2& spot_m) const noexcept {
    return (spot_m.cwiseAbs() - m_briefing.areaHalf_m).maxCoeff() <= kBeside_m;
}

double PalpationTrainee::depth_m(const Hand& hand) const noexcept {
    const double force =
        m_briefing.bandLow_N + m_settings.forceShare * (m_briefing.bandHigh_N - m_briefing.bandLow_N);
    const double share =
        m_settings.pressures < 2 ? 1.0 : 0.5 + 0.5 * hand.pressure / (m_settings.pressures - 1);
    return std::min(kDeepest_m, m_yield_m_per_N * force * share * hand.deep);
}

bool PalpationTrainee::nextSpot(std::size_t hand, Vec2& spot_m) noexcept {
    if (m_doing == Doing::search)
        return m_hands[hand].path.next(spot_m);
    if (m_doing != Doing::revisit || m_nextSpot >= m_spots || handFor(m_revisit[m_nextSpot]) != hand)
        return false;
    spot_m = m_revisit[m_nextSpot++];
    return true;
}

/// Sends a hand to a spot; a height < 0 is in the tissue, along the normal of the surface that it sees. Two
/// fingers form one hand, which turns so that both lie on the surface and presses along the normal between
/// them.
void PalpationTrainee::send(std::size_t hand, const Vec2& spot_m, double height_m,
                            double speed_m_per_s) noexcept {
    const Vec3 surface = m_surface.pointAt(spot_m);
    Vec3 along = Vec3::UnitX(), normal = m_surface.normalAt(spot_m);
    core::Quat turn = core::Quat::Identity();
    if (fingers() > 1) {
        const Vec2 other = spot_m + Vec2(m_briefing.fingerSpacing_m, 0.0);
        along = (m_surface.pointAt(other) - surface).normalized();
        const Vec3 between = normal + m_surface.normalAt(other);
        normal = (between - between.dot(along) * along).normalized();
        core::Mat3 axes;
        axes << along, normal.cross(along), normal;
        turn = core::Quat(axes);
    }
    for (std::size_t finger = 0; finger < fingers(); ++finger) {
        FingerOrder& order = m_orders[firstFinger(hand) + finger];
        const Vec3 pad = surface + static_cast<double>(finger) * m_briefing.fingerSpacing_m * along;
        order.surface_W = m_surface.pointAt(pad.head<2>());
        order.normal_W = m_surface.normalAt(pad.head<2>());
        order.goal_W = pad + height_m * normal;
        order.turn_W = turn;
        order.speed_m_per_s = speed_m_per_s;
    }
}

/// Moves straight up, above the whole organ.
void PalpationTrainee::rise(std::size_t hand) noexcept {
    for (std::size_t tool = firstFinger(hand); tool < firstFinger(hand) + fingers(); ++tool) {
        m_orders[tool].goal_W = m_wanted_W[tool];
        m_orders[tool].goal_W.z() =
            std::max(m_wanted_W[tool].z(), m_surface.highest_m() + m_settings.hover_m);
        m_orders[tool].speed_m_per_s = m_settings.reachSpeed_m_per_s;
    }
}

/// Judges by the first finger, because the others move with it.
bool PalpationTrainee::there(std::size_t hand, double within_m) const noexcept {
    const std::size_t tool = firstFinger(hand);
    return (m_orders[tool].goal_W - m_wanted_W[tool]).norm() <= within_m;
}

void PalpationTrainee::enter(Hand& hand, Hand::Step step) noexcept {
    hand.step = step;
    hand.since_s = m_now_s;
}

/// Moves out of contact when there is no force or no trial. A spot that was begun is begun again afterwards.
void PalpationTrainee::keepAway() noexcept {
    for (std::size_t tool = 0; tool < tools(); ++tool) {
        FingerOrder& order = m_orders[tool];
        order.buttons = 0;
        order.goal_W = m_wanted_W[tool];
        order.goal_W.z() = std::max(order.goal_W.z(), m_surface.highest_m() + kAway_m);
        order.speed_m_per_s = m_settings.reachSpeed_m_per_s;
        // Its attention to the present press ends
        order.attendUntil_s = std::min(order.attendUntil_s, m_now_s);
    }
    m_pressing = false;
    for (Hand& hand : m_hands)
        if (hand.step != Hand::Step::idle)
            hand.step = Hand::Step::rise;
}

bool PalpationTrainee::moveHands(bool newSpots) noexcept {
    bool busy = false;
    for (std::size_t hand = 0; hand < hands(); ++hand) {
        moveHand(hand, newSpots);
        if (m_hands[hand].step == Hand::Step::idle)
            moveHand(hand, newSpots);
        busy = busy || m_hands[hand].step != Hand::Step::idle;
    }
    return busy;
}

void PalpationTrainee::startSpot(std::size_t hand, const Vec2& spot_m) noexcept {
    Hand& own = m_hands[hand];
    const double jump = (m_wanted_W[firstFinger(hand)].head<2>() - spot_m).norm();
    const double beside_m = m_settings.aimSd_m;
    own.spot_m = spot_m + Vec2(beside_m * m_random.normal(), beside_m * m_random.normal());
    own.deep = std::exp(m_settings.pressSd * m_random.normal());
    own.pressure = 0;
    if (!m_surface.flat() && jump > kFarJump_m) {
        rise(hand);
        return enter(own, Hand::Step::rise);
    }
    send(hand, own.spot_m, m_settings.hover_m, m_settings.reachSpeed_m_per_s);
    enter(own, Hand::Step::hover);
}

void PalpationTrainee::startDown(std::size_t hand) noexcept {
    send(hand, m_hands[hand].spot_m, -depth_m(m_hands[hand]), m_settings.pressSpeed_m_per_s);
    enter(m_hands[hand], Hand::Step::down);
}

/// A motion that it starts now is felt a reaction delay later.
void PalpationTrainee::startHold(std::size_t hand) noexcept {
    Hand& own = m_hands[hand];
    own.intended_m = depth_m(own);
    for (std::size_t tool = firstFinger(hand); tool < firstFinger(hand) + fingers(); ++tool) {
        FingerOrder& order = m_orders[tool];
        if (!inside(order.surface_W.head<2>()))
            continue; // not to be searched
        ++order.press;
        order.pressure = own.pressure;
        order.attendFrom_s = m_now_s + m_settings.hand.reactionDelay_s + kSettle_s;
        order.attendUntil_s = m_now_s + m_settings.hand.reactionDelay_s + m_settings.hold_s;
    }
    enter(own, Hand::Step::hold);
}

void PalpationTrainee::moveHand(std::size_t hand, bool newSpots) noexcept {
    Hand& own = m_hands[hand];
    Vec2 spot;
    switch (own.step) {
    case Hand::Step::idle:
        if (newSpots && nextSpot(hand, spot))
            startSpot(hand, spot);
        return;
    case Hand::Step::rise:
        rise(hand);
        if (there(hand, kNear_m))
            enter(own, Hand::Step::over);
        return;
    case Hand::Step::over:
        send(hand, own.spot_m, 0.0, m_settings.reachSpeed_m_per_s);
        for (std::size_t tool = firstFinger(hand); tool < firstFinger(hand) + fingers(); ++tool)
            m_orders[tool].goal_W.z() = m_surface.highest_m() + m_settings.hover_m;
        if (there(hand, kNear_m))
            enter(own, Hand::Step::hover);
        return;
    case Hand::Step::hover:
        send(hand, own.spot_m, m_settings.hover_m, m_settings.reachSpeed_m_per_s);
        return there(hand, kNear_m) ? startDown(hand) : void();
    case Hand::Step::down:
        return there(hand, kDown_m) ? startHold(hand) : void();
    case Hand::Step::hold:
        if (m_now_s < own.since_s + m_settings.hold_s)
            return;
        if (++own.pressure < m_settings.pressures)
            return startDown(hand);
        send(hand, own.spot_m, m_settings.hover_m, m_settings.reachSpeed_m_per_s);
        return enter(own, Hand::Step::up);
    case Hand::Step::up:
        if (there(hand, kNear_m))
            enter(own, Hand::Step::idle);
        return;
    }
}

} // namespace chiron::operators
