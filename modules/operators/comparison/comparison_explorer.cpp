// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/comparison/comparison_explorer.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::operators {

using core::Vec3;
using simulation::ComparedAttribute;

namespace {

constexpr double kPull_N = 1.3; ///< force with which it pulls a usual tube and presses a usual pad
/// If a tube resists with more than this, the next trial's pulls are shorter ...
constexpr double kTooHard_N = 2.4;
/// ... so that they reach about this force: people pull to a force, not to a position.
constexpr double kEnough_N = 1.8;
constexpr double kShortestPull = 0.25; ///< share of the usual distance
/// It pulls with at least this multiple of the smallest force that is asked for, because the grip gives way,
/// too.
constexpr double kOverProbe = 1.5;
constexpr double kAbove_m = 0.014;   ///< height above a pad while moving to it
constexpr double kWaiting_m = 0.050; ///< height between trials
/// The same where it strokes the air meanwhile, because an instrument's friction depends on its depth.
constexpr double kOverPads_m = 0.010;
constexpr double kInAir_m = 0.006;   ///< above this height it touches no pad
constexpr double kSwing_m = 0.007;   ///< half of a stroke
constexpr int kTracks = 7;           ///< tracks along which a rough pad is stroked ...
constexpr double kTracks_m = 0.0048; ///< ... up to this distance on both sides
constexpr double kTaken_m = 0.0055;  ///< at this distance from a ring it knows that it holds the object
constexpr double kSetDown_m = 0.003; ///< at this distance below a ring it has put the object down
constexpr double kFromEdge_m = 0.0004;
constexpr double kSettled_s = 0.15; ///< time after the last movement for the arm to catch up

/// Share of a path that is covered at a share of its time, for minimum jerk (Flash & Hogan 1985), and its
/// slope.
double minimumJerk(double t) noexcept {
    return t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
}
double minimumJerkSlope(double t) noexcept {
    return 30.0 * t * t * (1.0 - t) * (1.0 - t);
}

} // namespace

Vec3 ComparisonExplorer::ring(int place) const noexcept {
    return {m_briefing.x_m[static_cast<std::size_t>(place)], 0.0, m_briefing.height_m};
}

ComparisonExplorer::Way ComparisonExplorer::hookedWay(const Vec3& ring, int step) const noexcept {
    const bool tube = m_briefing.attribute == ComparedAttribute::stiffness;
    const double up_m =
        tube ? m_pull * (kPull_N / m_briefing.usualStiffness_N_per_m + kPull_N / m_arm_N_per_m) : 0.020;
    switch (step) {
    case 0:
        return {ring + Vec3(0.0, 0.0, tube ? -0.003 : 0.0), 0.40};
    case 1:
        return {ring + Vec3(0.0, 0.0, up_m), 0.32};
    case 2:
        return tube ? Way{ring + Vec3(0.0, 0.0, -0.016), 0.36}
                    : Way{ring + Vec3(0.0, 0.0, up_m - 0.009), 0.20};
    case 3:
        return tube ? Way{} : Way{ring + Vec3(0.0, 0.0, up_m), 0.20};
    case 4:
        return tube ? Way{} : Way{ring + Vec3(0.0, 0.0, -0.008), 0.32}; // onto its bed, and pressed
    case 5:
        return tube ? Way{} : Way{ring + Vec3(0.0, 0.0, 0.006), 0.20}; // let go
    case 6:
        return tube ? Way{} : Way{ring + Vec3(0.0, 0.0, 0.022), 0.15};
    default:
        return {};
    }
}

ComparisonExplorer::Way ComparisonExplorer::pressedWay(const Vec3& pad, int step) const noexcept {
    const double light_N = m_briefing.attribute == ComparedAttribute::friction ? 0.6 * kPull_N : kPull_N;
    const auto depth = [&](double force_N) {
        return -force_N / m_briefing.usualStiffness_N_per_m - force_N / m_arm_N_per_m;
    };
    const Vec3 low(0.0, 0.0, depth(light_N));
    const Vec3 lower(0.0, 0.0,
                     depth(m_briefing.attribute == ComparedAttribute::friction ? 1.5 * kPull_N : kPull_N));
    const Vec3 aside(0.0, kSwing_m, 0.0);
    if (m_briefing.attribute == ComparedAttribute::deformation) {
        switch (step) {
        case 0:
            return {pad + Vec3(0.0, 0.0, 0.006), 0.30};
        case 1:
            return {pad + lower, 0.12}; // quickly; then it stays
        case 2:
            return {pad + lower, 0.90};
        case 3:
            return {pad + Vec3(0.0, 0.0, kAbove_m), 0.20};
        default:
            return {};
        }
    }
    switch (step) {
    case 0:
        return {pad - aside + Vec3(0.0, 0.0, 0.004), 0.34};
    case 1:
        return {pad - aside + low, 0.15};
    case 2:
        return {pad + aside + low, 0.20};
    case 3:
        return {pad - aside + low, 0.20};
    case 4:
        return {pad + aside + lower, 0.22};
    case 5:
        return {pad - aside + lower, 0.22};
    case 6:
        return {pad - aside + Vec3(0.0, 0.0, kAbove_m), 0.18};
    default:
        return {};
    }
}

/// Feels a rough pad along several tracks that are so far apart that each meets heights of its own.
ComparisonExplorer::Way ComparisonExplorer::roughWay(const Vec3& pad, int step) const noexcept {
    const double pressed_m = kPull_N / m_briefing.usualStiffness_N_per_m + kPull_N / m_arm_N_per_m;
    const Vec3 side(-kTracks_m, step % 2 == 1 ? -kSwing_m : kSwing_m, -pressed_m);
    if (step == 0)
        return {pad + Vec3(side.x(), -kSwing_m, 0.004), 0.34};
    if (step == 1)
        return {pad + side, 0.15};
    if (step < 2 + kTracks)
        return {pad + side + Vec3(2.0 * kTracks_m * (step - 1) / kTracks, 0.0, 0.0), 0.20};
    return step == 2 + kTracks ? Way{pad + Vec3(kTracks_m, -side.y(), kAbove_m), 0.18} : Way{};
}

ComparisonExplorer::Way ComparisonExplorer::way(int place, int step) const noexcept {
    if (simulation::isHooked(m_briefing.attribute))
        return hookedWay(ring(place), step);
    const Vec3 pad = ring(place) - Vec3(0.0, 0.0, m_briefing.height_m);
    return m_briefing.attribute == ComparedAttribute::roughness ? roughWay(pad, step) : pressedWay(pad, step);
}

bool ComparisonExplorer::strokes() const noexcept {
    return m_briefing.attribute == ComparedAttribute::viscosity ||
           m_briefing.attribute == ComparedAttribute::friction ||
           m_briefing.attribute == ComparedAttribute::roughness;
}

void ComparisonExplorer::begin() noexcept {
    for (ExploredPlace& place : m_places)
        place.reset();
    m_air.learn();
    m_taken.fill(false);
    m_takes.fill(true);
    m_explored = false;
    m_moving = true;
    m_place = 0;
    m_step = -1;
    nextWay();
}

/// Continues from the present target. An empty Way (target at the origin) ends the visit of a place.
void ComparisonExplorer::nextWay() noexcept {
    m_at = m_way.to;
    m_way_s = 0.0;
    ++m_step;
    const bool over = m_step > kLastStep || way(m_place, m_step).to == Vec3::Zero();
    if (over && m_place + 1 < m_briefing.places) {
        ++m_place;
        m_step = 0;
    } else if (over) {
        m_moving = false;
        m_way = {m_at, m_reaction_s + kSettled_s};
        return;
    }
    m_way = way(m_place, m_step);
}

/// Learns from the previous trial: the arm reacts a fifth of a second after the hand has felt a force, too
/// late for the same pull.
void ComparisonExplorer::learnPull() noexcept {
    const double shortest = std::clamp(kOverProbe * m_briefing.probe_N / kPull_N, kShortestPull, 1.0);
    if (m_hardest_N > kTooHard_N)
        m_pull = std::max(shortest, m_pull * kEnough_N / m_hardest_N);
    m_hardest_N = 0.0;
}

void ComparisonExplorer::notice(const mechanisms::HandPerception& seen) noexcept {
    const bool working =
        seen.cues.phase == core::TrialPhase::running && seen.cues.force == core::ForceState::on;
    if (working && static_cast<int>(seen.cues.trial) != m_trial) {
        m_trial = seen.cues.trial;
        m_calm = false;
        learnPull();
        begin();
        // The trial is over: moves out of the way and waits for the next one
    } else if (!m_calm && seen.cues.phase != core::TrialPhase::running) {
        m_calm = true;
        m_moving = false;
        m_explored = false;
        m_at = m_way.to;
        m_way_s = 0.0;
        m_way = {Vec3(m_briefing.x_m[0], -kSwing_m, strokes() ? kOverPads_m : kWaiting_m), 0.45};
    }
}

mechanisms::HandIntention ComparisonExplorer::decide(const mechanisms::HandPerception& seen) noexcept {
    if (seen.time_s <= 0.0) {
        m_at = seen.p_DT;
        m_way = {Vec3(m_briefing.x_m[0], -kSwing_m, strokes() ? kOverPads_m : kWaiting_m), 0.6};
        m_way_s = 0.0;
    }
    notice(seen);
    feel(seen);
    m_way_s += core::kTickSeconds;
    if (m_way_s >= m_way.time_s && m_moving)
        nextWay();
    else if (m_way_s >= m_way.time_s && !m_calm)
        m_explored = true;
    mechanisms::HandIntention wanted;
    const double share = std::min(1.0, m_way_s / m_way.time_s);
    wanted.p_DDesired = m_at + minimumJerk(share) * (m_way.to - m_at);
    wanted.v_DDesired = minimumJerkSlope(share) / m_way.time_s * (m_way.to - m_at);
    if (m_calm && m_way_s > m_way.time_s && strokes()) { // strokes in the air meanwhile
        const double phase = 2.0 * core::kPi * 2.4 * (m_way_s - m_way.time_s);
        wanted.p_DDesired.y() += kSwing_m * (1.0 - std::cos(phase));
        wanted.v_DDesired.y() += kSwing_m * 2.0 * core::kPi * 2.4 * std::sin(phase);
    }
    return wanted;
}

bool ComparisonExplorer::feels(int place, const Vec3& tip, double& displacement_m) const noexcept {
    const Vec3 top = ring(place);
    switch (m_briefing.attribute) {
    case ComparedAttribute::stiffness: {
        const Vec3 foot(top.x(), 0.0, 0.0);
        displacement_m = (tip - foot).norm() - m_briefing.height_m;
        return displacement_m > 0.0015;
    }
    case ComparedAttribute::mass:
        displacement_m = tip.z() - top.z();
        return displacement_m > 0.008;
    case ComparedAttribute::deformation:
        displacement_m = -tip.z();
        return displacement_m > 0.0;
    case ComparedAttribute::roughness:
        return feelsRough(place, displacement_m);
    case ComparedAttribute::friction:
    case ComparedAttribute::viscosity:
        break;
    }
    displacement_m = -tip.z();
    return displacement_m > 0.001;
}

/// Uses only the flat top, because beyond it the edge falls off by more than any roughness.
bool ComparisonExplorer::feelsRough(int place, double& displacement_m) const noexcept {
    const Vec3& tip = m_instrument.tip();
    displacement_m = -tip.z();
    return displacement_m > 0.001 &&
           std::hypot(tip.x() - ring(place).x(), tip.y()) < m_briefing.padRadius_m - kFromEdge_m;
}

void ComparisonExplorer::feel(const mechanisms::HandPerception& seen) noexcept {
    FeltSample felt;
    felt.force = seen.f_T_D;
    felt.velocity = seen.v_DT;
    felt.acceleration = (seen.v_DT - m_lastVelocity) / core::kTickSeconds;
    m_lastVelocity = seen.v_DT;
    m_instrument.feel(seen.p_DT, seen.f_T_D);
    felt.own = m_instrument.own();
    if (m_calm && seen.p_DT.z() > kInAir_m && m_way_s > m_way.time_s + m_reaction_s)
        m_air.add(felt);
    if (m_calm || m_explored || seen.cues.force != core::ForceState::on)
        return;
    const Vec3 tip = seen.p_DT + seen.f_T_D / m_grip_N_per_m; // it sees its tip
    for (int place = 0; place < m_briefing.places; ++place) {
        if (std::abs(tip.x() - m_briefing.x_m[static_cast<std::size_t>(place)]) > 0.006)
            continue;
        const auto index = static_cast<std::size_t>(place);
        const bool there = feels(place, tip, felt.displacement_m);
        const bool slack = m_briefing.attribute != ComparedAttribute::stiffness || felt.displacement_m <= 0.0;
        m_taken[index] = m_taken[index] || (m_takes[index] && slack && (tip - ring(place)).norm() < kTaken_m);
        if (m_places[index].samples() > 0 && tip.z() < ring(place).z() - kSetDown_m)
            m_taken[index] = m_takes[index] = false; // put down, or slack: it is about to let go
        if (there)
            m_hardest_N = std::max(m_hardest_N, felt.force.norm());
        if (there && (m_taken[index] || !simulation::isHooked(m_briefing.attribute)))
            m_places[index].add(m_briefing.attribute, felt, m_air,
                                {m_briefing.usualStiffness_N_per_m, m_briefing.share});
    }
}

double ComparisonExplorer::estimate(int place) const noexcept {
    if (place < 0 || place >= m_briefing.places)
        return std::numeric_limits<double>::quiet_NaN();
    return m_places[static_cast<std::size_t>(place)].estimate(m_briefing.attribute);
}

} // namespace chiron::operators
