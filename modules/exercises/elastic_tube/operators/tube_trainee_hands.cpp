// SPDX-License-Identifier: GPL-3.0-or-later
// The actions of the single hands of a TubeTrainee.
#include "cues/laparoscopy_cues.h"
#include "modules/exercises/elastic_tube/operators/tube_trainee.h"
#include "operators/laparoscopy/movement.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::LaparoscopyCues;
using core::Vec3;

namespace {
// Habits that all operators share: assumptions.
constexpr double kHover_m = 0.012; ///< height from which it approaches a grip
constexpr double kAbove_m = 0.010; ///< height that it keeps while it is not yet over the grip
/// Time that it waits for a hold after closing before it tries again.
constexpr double kClosing_s = 1.2;
constexpr double kGetsOff_m_per_s = 0.02; ///< speed with which it moves away after letting go
constexpr double kGettingOff_s = 0.6;
constexpr double kSteering_per_s = 1.0; ///< gain towards the direction in which it wants to pull
constexpr double kSteering_m_per_s = 0.010;
constexpr double kUp_m = 0.12;  ///< pulls towards a point at this height over the base …
constexpr double kInward = 0.5; ///< … and at this share of the distance to below its entry point
/// Direction in which a fold is drawn: away from the hands, and up.
constexpr double kBack = 0.8, kLift = 0.6;
constexpr double kSpan_m = 0.045; ///< height at which a tube is held between two instruments
} // namespace

void TubeTrainee::begin(Hand& hand, Doing doing, double now_s) noexcept {
    hand.doing = doing;
    hand.began_s = now_s;
}

/// Opens the jaws and returns to the start positions.
void TubeTrainee::rest(const GraspLook& felt, GraspWishes& wishes) noexcept {
    for (std::size_t i = 0; i < m_all; ++i) {
        Hand& hand = m_hands[i];
        if (hand.doing != Doing::wait)
            begin(hand, Doing::wait, felt.first().time_s);
        wishes[i].velocity_m_per_s =
            velocityTo(hand.rest, hand.place, m_settings.moveGain_per_s, m_settings.reachSpeed_m_per_s);
        wishes[i].jaw_rad = m_settings.openJaw_rad;
        wishes[i].jawSpeed_rad_per_s = m_settings.jawSpeed_rad_per_s;
    }
}

void TubeTrainee::decide(std::size_t i, const GraspLook& felt, GraspWish& wish) noexcept {
    Hand& hand = m_hands[i];
    const LaparoscopyCues& screen = felt.first().screen();
    const double now_s = felt.first().time_s;
    const int grip = gripOf(i, screen);
    wish.jawSpeed_rad_per_s = m_settings.jawSpeed_rad_per_s;
    if (grip == kNone) {
        const bool letsGo = holds(i, screen) || hand.doing == Doing::hold;
        if (letsGo)
            begin(hand, Doing::letGo, now_s);
        else if (hand.doing != Doing::letGo || now_s - hand.began_s > kGettingOff_s)
            begin(hand, Doing::wait, hand.doing == Doing::wait ? hand.began_s : now_s);
        wish.jaw_rad = m_settings.openJaw_rad;
        wish.velocity_m_per_s =
            hand.doing == Doing::letGo
                ? Vec3(0.0, 0.0, kGetsOff_m_per_s)
                : velocityTo(hand.rest, hand.place, m_settings.moveGain_per_s, m_settings.reachSpeed_m_per_s);
        return;
    }
    if (holds(i, screen)) {
        if (hand.doing != Doing::hold)
            begin(hand, Doing::hold, now_s);
        wish.jaw_rad = heldJaw(hand);
        return work(i, felt.hand[i], wish);
    }
    if (hand.doing != Doing::reach && hand.doing != Doing::close)
        begin(hand, Doing::reach, now_s);
    seek(i, felt.hand[i], vectorOf(screen.p_WGrip[static_cast<std::size_t>(hand.grip)]), wish);
}

double TubeTrainee::heldJaw(Hand& hand) noexcept {
    return std::max(0.0, m_settings.heldJaw_rad + hand.jaw.value());
}

/// Moves to the grip from above, then closes the jaw.
void TubeTrainee::seek(std::size_t i, const GraspPercept& felt, const Vec3& grip, GraspWish& wish) noexcept {
    Hand& hand = m_hands[i];
    const Vec3 off = grip - hand.place;
    wish.jaw_rad = m_settings.openJaw_rad;
    if (hand.doing == Doing::close) {
        wish.jaw_rad = m_settings.heldJaw_rad;
        wish.velocity_m_per_s = velocityTo(grip, hand.place, m_settings.moveGain_per_s, 0.01);
        const double closing_s =
            kClosing_s + (m_settings.openJaw_rad - m_settings.heldJaw_rad) / m_settings.jawSpeed_rad_per_s;
        if (felt.time_s - hand.began_s > closing_s)
            begin(hand, Doing::reach, felt.time_s);
        return;
    }
    const bool beside = off.head<2>().norm() > kAbove_m;
    const Vec3 goal = beside ? Vec3(grip + Vec3(0.0, 0.0, kHover_m)) : grip;
    wish.velocity_m_per_s =
        velocityTo(goal, hand.place, m_settings.moveGain_per_s, m_settings.reachSpeed_m_per_s);
    if (off.norm() > m_settings.aim_m)
        hand.began_s = felt.time_s;
    else if (felt.time_s - hand.began_s > m_settings.settle_s)
        begin(hand, Doing::close, felt.time_s);
}

TensionView TubeTrainee::foldView(const GraspPercept& felt) const noexcept {
    const LaparoscopyCues& screen = felt.screen();
    const Hand& hand = m_hands[m_count];
    TensionView view;
    view.time_s = felt.time_s;
    view.tension_N = screen.retractionShown ? felt.retraction_N : hand.force.norm();
    const double beside_N =
        (m_settings.retractShare - 0.5) * (screen.retractionHigh_N - screen.retractionLow_N);
    if (screen.retractionHigh_N > 0.0) {
        view.low_N = screen.retractionLow_N + beside_N;
        view.high_N = screen.retractionHigh_N + beside_N;
    }
    view.length_m = (hand.place - vectorOf(screen.p_WFoldBase)).norm();
    view.restLength_m = view.length_m; // a fold cannot tear: it pulls further until the pull is right
    view.dwell = screen.foldOpen ? view.time_s : 0.0; // counts while the fold is open
    return view;
}

/// Observes, at every look, how this fold responds.
void TubeTrainee::mindFold(const GraspPercept& felt) noexcept {
    const bool holds = (felt.screen().foldHeldBy >> m_count & 1U) != 0;
    if (holds && !m_retracting)
        m_retraction.begin();
    m_retracting = holds;
    if (holds)
        m_retraction.look(foldView(felt));
}

/// Takes the fold by its edge, draws it back and up, and keeps its pull in the band until the trial ends.
void TubeTrainee::retract(const GraspPercept& felt, GraspWish& wish) noexcept {
    Hand& hand = m_hands[m_count];
    const LaparoscopyCues& screen = felt.screen();
    wish.jawSpeed_rad_per_s = m_settings.jawSpeed_rad_per_s;
    if (!m_retracting) {
        if (hand.doing != Doing::reach && hand.doing != Doing::close)
            begin(hand, Doing::reach, felt.time_s);
        return seek(m_count, felt, vectorOf(screen.p_WFoldEdge), wish);
    }
    if (hand.doing != Doing::hold)
        begin(hand, Doing::hold, felt.time_s);
    wish.jaw_rad = heldJaw(hand);
    const Vec3 from = vectorOf(screen.p_WFoldBase);
    const Vec3 span = hand.place - from;
    const double length = std::max(span.norm(), 1e-3);
    const Vec3 along = span / length;
    Vec3 steer =
        velocityTo(from + length * Vec3(0.0, kBack, kLift), hand.place, kSteering_per_s, kSteering_m_per_s);
    steer -= steer.dot(along) * along;
    wish.velocity_m_per_s = m_retraction.speed_m_per_s(foldView(felt)) * along + steer;
}

void TubeTrainee::work(std::size_t i, const GraspPercept& felt, GraspWish& wish) noexcept {
    const LaparoscopyCues& screen = felt.screen();
    if (m_briefing.goal == TubeGoal::bring)
        wish.velocity_m_per_s = bring(i, screen);
    else
        wish.velocity_m_per_s = m_pulling ? pull(i, screen) : Vec3(Vec3::Zero());
}

Vec3 TubeTrainee::otherEnd(std::size_t hand, const LaparoscopyCues& screen) const noexcept {
    if (m_count == 2)
        return m_hands[1 - hand].place;
    for (int grip = 0; grip < screen.grips; ++grip)
        if (screen.gripAnchored[static_cast<std::size_t>(grip)])
            return vectorOf(screen.p_WGrip[static_cast<std::size_t>(grip)]);
    return {m_hands[hand].place.x(), m_hands[hand].place.y(), 0.0};
}

/// Pulls away from the other end, and steers towards where there is room. Two hands share the distance.
Vec3 TubeTrainee::pull(std::size_t i, const LaparoscopyCues& screen) const noexcept {
    const Hand& hand = m_hands[i];
    const Vec3 from = otherEnd(i, screen);
    const Vec3 span = hand.place - from;
    const double length = std::max(span.norm(), 1e-3);
    const Vec3 along = span / length;
    Vec3 wanted; // where this end would be at its present distance from the other end
    if (m_count == 2) {
        const Vec3 middle = 0.5 * (hand.place + from);
        const double side = i == 0 ? 1.0 : -1.0;
        wanted = Vec3(0.0, 0.0, kSpan_m) + Vec3(side * 0.5 * length, 0.0, 0.0);
        wanted.head<2>() += middle.head<2>();
    } else {
        const auto& place = m_briefing.places[i].origin_m;
        const Vec3 under(place[0], place[1], 0.0);
        // The mark is straight above the base
        const double inward = m_briefing.goal == TubeGoal::mark ? 0.0 : kInward;
        const Vec3 direction = (inward * (under - from) + Vec3(0.0, 0.0, kUp_m)).normalized();
        wanted = from + length * direction;
    }
    Vec3 steer = velocityTo(wanted, hand.place, kSteering_per_s, kSteering_m_per_s);
    steer -= steer.dot(along) * along;
    return m_speed_m_per_s / static_cast<double>(m_count) * along + steer;
}

/// Leads the free end to its target, wherever this hand holds the tube. A hand that is about to hand over
/// keeps still.
Vec3 TubeTrainee::bring(std::size_t i, const LaparoscopyCues& screen) const noexcept {
    const int end = m_hands[0].grip;
    if (!screen.targetShown || screen.step == core::LaparoscopyStep::handOver || end == kNone)
        return Vec3::Zero();
    // Tip and end are seen together, so an error of sight affects both in the same way.
    const Vec3 held = vectorOf(screen.p_WGrip[static_cast<std::size_t>(m_hands[i].grip)]);
    const Vec3 ahead = vectorOf(screen.p_WGrip[static_cast<std::size_t>(end)]) - held;
    return velocityTo(vectorOf(screen.p_WTarget), m_hands[i].place + ahead, m_settings.moveGain_per_s,
                      m_settings.bringSpeed_m_per_s);
}

} // namespace chiron::operators
