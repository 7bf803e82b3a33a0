// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/elastic_tube/operators/tube_trainee.h"

#include "cues/laparoscopy_cues.h"
#include "operators/laparoscopy/movement.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::LaparoscopyCues;
using core::Vec3;

namespace {
constexpr double kSmoothing = 0.1; ///< share per observation for smoothing position and force: 0.1 s

bool anchored(const LaparoscopyCues& screen, int grip) noexcept {
    return screen.gripAnchored[static_cast<std::size_t>(grip)];
}
} // namespace

void TubeTrainee::think(const GraspLook& felt, GraspWishes& wishes) noexcept {
    notice(felt);
    const GraspPercept& first = felt.first();
    const bool working =
        first.working() && first.screen().present && first.screen().objectShown && first.screen().tube;
    if (!working) {
        m_working = m_pulling = false;
        return rest(felt, wishes);
    }
    if (!m_working) {
        m_working = true;
        m_decided_s = -1.0;
        for (Hand& hand : m_hands)
            hand.grip = kNone;
    }
    const TensionView now = view(felt);
    const bool pulling = allHold(first.screen()) && m_briefing.goal != TubeGoal::bring;
    if (pulling && !m_pulling)
        m_tension.begin();
    m_pulling = pulling;
    if (m_briefing.retracts)
        mindFold(felt.hand[m_count]);
    if (pulling)
        m_tension.look(now);
    if (first.time_s < m_decided_s + m_settings.attention_s)
        return;
    m_decided_s = first.time_s;
    share(first.screen());
    m_speed_m_per_s = pulling ? m_tension.speed_m_per_s(now) : 0.0;
    for (std::size_t i = 0; i < m_count; ++i)
        decide(i, felt, wishes[i]);
    if (m_briefing.retracts)
        retract(felt.hand[m_count], wishes[m_count]);
}

void TubeTrainee::notice(const GraspLook& felt) noexcept {
    for (std::size_t i = 0; i < m_all; ++i) {
        Hand& hand = m_hands[i];
        hand.jaw.advance(m_random);
        if (!m_awake) {
            hand.place = felt.hand[i].place;
            hand.rest = felt.hand[i].place;
        }
        smoothTowards(hand.place, felt.hand[i].place, kSmoothing);
        smoothTowards(hand.force, felt.hand[i].force, kSmoothing);
    }
    m_awake = true;
}

/// One hand takes the free end. Of two free ends each hand takes the one on its side. To hand over, the
/// second hand takes the place between the free end and the base.
void TubeTrainee::share(const LaparoscopyCues& screen) noexcept {
    int far = kNone, other = kNone;
    for (int grip = 0; grip < screen.grips; ++grip) {
        if (anchored(screen, grip))
            continue;
        const double at = screen.gripAt[static_cast<std::size_t>(grip)];
        if (far == kNone || at > screen.gripAt[static_cast<std::size_t>(far)]) {
            other = far;
            far = grip;
        } else {
            other = grip;
        }
    }
    if (far == kNone)
        return;
    if (m_count == 1 || m_briefing.goal == TubeGoal::bring) {
        m_hands[0].grip = far;
        m_hands[1].grip = other;
    } else if (m_hands[0].grip == kNone && other != kNone) {
        const bool onTheRight = screen.p_WGrip[static_cast<std::size_t>(far)][0] >=
                                screen.p_WGrip[static_cast<std::size_t>(other)][0];
        m_hands[0].grip = onTheRight ? far : other;
        m_hands[1].grip = onTheRight ? other : far;
    }
}

/// The place that this hand has to hold now.
int TubeTrainee::gripOf(std::size_t hand, const LaparoscopyCues& screen) const noexcept {
    if (m_briefing.retracts && !screen.foldOpen && !holds(hand, screen))
        return kNone; // the tube lies under the fold
    if (m_briefing.goal != TubeGoal::bring || m_count == 1)
        return m_hands[hand].grip;
    const bool second = holds(1, screen);
    if (hand == 0)
        return second ? kNone : m_hands[0].grip;
    const bool ready = second || (screen.step == core::LaparoscopyStep::handOver && holds(0, screen));
    return ready ? m_hands[1].grip : kNone;
}

bool TubeTrainee::holds(std::size_t hand, const LaparoscopyCues& screen) const noexcept {
    const int grip = m_hands[hand].grip;
    return grip != kNone && (screen.gripHeldBy[static_cast<std::size_t>(grip)] & (1U << hand)) != 0;
}

bool TubeTrainee::allHold(const LaparoscopyCues& screen) const noexcept {
    for (std::size_t i = 0; i < m_count; ++i)
        if (!holds(i, screen))
            return false;
    return true;
}

TensionView TubeTrainee::view(const GraspLook& felt) const noexcept {
    const LaparoscopyCues& screen = felt.first().screen();
    TensionView view;
    view.time_s = felt.first().time_s;
    view.restLength_m = screen.restLength_m;
    view.length_m = screen.restLength_m + felt.first().stretch_m;
    view.dwell = screen.dwell;
    // A length is to be kept: convert it to the tension of a tube with the assumed stiffness
    if (m_briefing.goal == TubeGoal::mark) {
        const double k = m_settings.assumedStiffness_N_per_m;
        const bool seen = screen.targetShown;
        const double mark_m =
            seen ? (vectorOf(screen.p_WTarget) - otherEnd(0, screen)).norm() - screen.restLength_m
                 : (m_briefing.markRatio - 1.0) * screen.restLength_m;
        const double either_m = seen ? screen.targetRadius_m : m_briefing.markTolerance * screen.restLength_m;
        view.tension_N = k * felt.first().stretch_m;
        view.low_N = k * (mark_m - either_m);
        view.high_N = k * (mark_m + either_m);
        return view;
    }
    view.low_N = screen.bandLow_N;
    view.high_N = screen.bandHigh_N;
    view.tension_N = felt.first().tension_N;
    if (!screen.tensionShown) { // by feel: both hands feel the same tension
        for (std::size_t i = 0; i < m_count; ++i)
            view.tension_N += m_hands[i].force.norm() / static_cast<double>(m_count);
    }
    return view;
}

} // namespace chiron::operators
