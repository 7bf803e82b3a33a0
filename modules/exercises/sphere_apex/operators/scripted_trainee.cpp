// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/operators/scripted_trainee.h"

#include "core/tool_state.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::Vec2;
using core::Vec3;

namespace {
// Habits that all trainees share: assumptions.
constexpr double kForceSmoothing = 0.1; ///< share per observation for smoothing the felt force: 0.1 s
/// The same for its direction: 0.25 s, about the duration of a look in PerceptionSettings.
constexpr double kLeanSmoothing = 0.04;
constexpr double kProbe_s = 0.7;       ///< how long it feels the surface that it came down on
constexpr double kFound_N = 0.5;       ///< pressure that stops a free movement
constexpr double kSideSlope = 0.6;     ///< sine of 37°: the surface is inclined and is not the table
constexpr double kHill_m = 0.010;      ///< felt height above the table that makes it a hill
constexpr double kRise_m = 0.005;      ///< felt rise while climbing that makes it a hill
constexpr double kFloor_m = 0.085;     ///< below its start position: there is no table
constexpr double kLift_m_per_s = 0.06; ///< upwards off the table, before a scan
constexpr double kSteadying_s = 0.8;   ///< time on top before it moves on
constexpr double kFollowing = 0.5;     ///< share of the felt slope that it moves along with
/// Distance at which it is near enough to the place that it wants to mark ...
constexpr double kThere_m = 0.002;
constexpr double kThere_s = 0.2; ///< ... and the time that it has to stay there
constexpr double kLongestClimb_s = 10.0;
constexpr double kFallen_m = 0.012; ///< below where the search began: it has slid off
constexpr double kPress_s = 0.15;   ///< how long the button is held
} // namespace

mechanisms::HandIntention ScriptedTrainee::decide(const mechanisms::HandPerception& seen) noexcept {
    if (seen.time_s <= 0.0)
        m_reach.start(seen.p_DT); // the arm begins where the tool is
    if (m_senses.feel(seen))
        think(m_senses.percept());
    return m_reach.advance(m_buttons);
}

void ScriptedTrainee::think(const Percept& felt) noexcept {
    if (!m_awake) {
        m_awake = true;
        m_home = felt.place;
        m_table_m = felt.place.z() - m_settings.startHeight_m;
    }
    m_force += kForceSmoothing * (felt.force - m_force);
    m_lean += kLeanSmoothing * (felt.force - m_lean);
    m_place += kForceSmoothing * (felt.place.head<2>() - m_place);
    if (felt.touching)
        m_lastTouch = felt.place;
    m_lostFor_s = felt.touching ? 0.0 : m_lostFor_s + Senses::kLook_s;
    const bool working =
        felt.cues.phase == core::TrialPhase::running && felt.cues.force == core::ForceState::on;
    if (!working && m_stage != Stage::rest)
        enter(Stage::rest, felt);
    else if (working && m_stage == Stage::rest)
        beginTrial(felt);
    else if (outOfTime(felt))
        enter(m_stage == Stage::search ? Stage::approach : Stage::press, felt);
    act(felt);
}

void ScriptedTrainee::act(const Percept& felt) noexcept {
    switch (m_stage) {
    case Stage::rest:
        return rest(felt);
    case Stage::lower:
        return lower(felt);
    case Stage::probe:
        return probe(felt);
    case Stage::scan:
        return scan(felt);
    case Stage::climb:
        return climb(felt);
    case Stage::search:
        return search(felt);
    case Stage::approach:
        return approach(felt);
    case Stage::settle:
        return settle(felt);
    case Stage::press:
        return press(felt);
    case Stage::done:
        return moveOnSurface(Vec2::Zero(), felt);
    }
}

void ScriptedTrainee::enter(Stage stage, const Percept& felt) noexcept {
    m_stage = stage;
    m_entered_s = felt.time_s;
    m_buttons = 0;
    m_flatFor_s = 0.0;
    m_thereFor_s = 0.0;
    m_lostFor_s = 0.0;
    if (stage == Stage::climb)
        m_climbFrom_m = felt.place.z();
    if (stage == Stage::search) {
        m_topHeight_m = felt.place.z();
        m_steady = false;
    }
}

void ScriptedTrainee::beginTrial(const Percept& felt) noexcept {
    m_trialBegan_s = felt.time_s;
    m_scanHeight_m = m_settings.scanHeight_m;
    m_touchdown = felt.objectSeen ? felt.seenApex : Vec2(m_home.head<2>());
    m_searched = false;
    m_tableTouched = false;
    m_path.begin();
    enter(Stage::lower, felt);
}

bool ScriptedTrainee::outOfTime(const Percept& felt) const noexcept {
    if (m_stage == Stage::rest || m_stage == Stage::press || m_stage == Stage::done)
        return false;
    const bool impatient = felt.time_s - m_trialBegan_s > m_settings.patience_s;
    return (impatient && m_stage != Stage::approach && m_stage != Stage::settle) ||
           felt.cues.timeLeft_s < 1.0;
}

Vec2 ScriptedTrainee::believedApex(const Percept& felt) const noexcept {
    return felt.objectSeen ? felt.seenApex : m_technique->estimate();
}

void ScriptedTrainee::rest(const Percept& felt) noexcept {
    const bool lifted = felt.place.z() > m_home.z() - 0.010;
    const Vec2 here = felt.place.head<2>();
    moveFreely(lifted ? Vec2(m_home.head<2>()) : here, m_home.z(), m_settings.reachSpeed_m_per_s, felt);
}

void ScriptedTrainee::lower(const Percept& felt) noexcept {
    const Vec2 here = felt.place.head<2>();
    if (m_force.norm() < kFound_N) {
        const bool above = (m_touchdown - here).norm() < 0.006;
        const Vec2 across = towards(m_touchdown, here, m_settings.reachSpeed_m_per_s);
        m_reach.wish(Vec3(across.x(), across.y(), above ? -m_settings.lowerSpeed_m_per_s : 0.0));
        if (felt.place.z() < m_home.z() - kFloor_m) // nothing is there: go on as if this were the table
            enter(Stage::scan, felt);
        return;
    }
    m_pressGoal_m = m_reach.place().z();
    enter(felt.objectSeen ? Stage::approach : Stage::probe, felt);
}

void ScriptedTrainee::probe(const Percept& felt) noexcept {
    moveOnSurface(Vec2::Zero(), felt);
    if (since(felt) < kProbe_s)
        return;
    const double height = felt.place.z();
    const bool inclined = std::hypot(m_lean.x(), m_lean.y()) > kSideSlope * m_lean.norm();
    m_cameDown_m = height;
    if (inclined)
        return enter(Stage::climb, felt);
    touchedTable(height);
    enter(Stage::scan, felt);
}

void ScriptedTrainee::touchedTable(double height_m) noexcept {
    m_table_m = height_m;
    m_tableTouched = true;
}

void ScriptedTrainee::scan(const Percept& felt) noexcept {
    const Vec2 end = Vec2(m_home.head<2>()) + m_path.end();
    const double height = m_table_m + m_scanHeight_m;
    if (since(felt) < 0.4 || (felt.touching && since(felt) < 1.5)) // off the table first
        return m_reach.wish(Vec3(0.0, 0.0, kLift_m_per_s));
    if (m_force.norm() > kFound_N)
        return enter(Stage::climb, felt);
    const Vec2 here = felt.place.head<2>();
    const double speed = m_path.onLine() ? m_settings.scanSpeed_m_per_s : m_settings.reachSpeed_m_per_s;
    moveFreely(end, height, speed, felt);
    if ((end - here).norm() > 0.008 || m_path.next())
        return;
    // No line met anything: feel for the table again elsewhere, and scan a little lower.
    const double angle = m_random.uniform(0.0, 2.0 * core::kPi);
    m_path.begin();
    m_touchdown =
        Vec2(m_home.head<2>()) + 0.5 * m_settings.scanRadius_m * Vec2(std::cos(angle), std::sin(angle));
    m_scanHeight_m = std::max(0.004, m_scanHeight_m - 0.002);
    enter(Stage::lower, felt);
}

void ScriptedTrainee::climb(const Percept& felt) noexcept {
    const double pressure = m_force.norm();
    if (!felt.touching) { // lost contact: move back to where it was, and down
        const Vec2 back =
            towards(m_lastTouch.head<2>(), felt.place.head<2>(), 2.0 * m_settings.climbSpeed_m_per_s);
        m_reach.wish(Vec3(back.x(), back.y(), -m_settings.climbSpeed_m_per_s));
        if (felt.place.z() < m_home.z() - kFloor_m)
            enter(Stage::scan, felt);
        return;
    }
    const Vec3 outward = m_lean.normalized();
    const Vec3 upward = Vec3::UnitZ() - outward.z() * outward;
    const double steepness = std::hypot(outward.x(), outward.y());
    const bool flat = outward.z() > 0.0 && steepness < m_settings.topSlope;
    m_flatFor_s = flat ? m_flatFor_s + Senses::kLook_s : 0.0;
    // Felt height drifts, so a rise while climbing means a hill at whatever height. Otherwise the height of
    // the table that was touched in this trial decides.
    const bool risen = felt.place.z() > m_climbFrom_m + kRise_m;
    const double flatBelow_m = m_tableTouched ? m_table_m + kHill_m : m_cameDown_m + kRise_m;
    const bool low = !risen && felt.place.z() < flatBelow_m;
    if (m_flatFor_s > 0.25 || since(felt) > kLongestClimb_s) {
        m_pressGoal_m = m_reach.place().z() - m_settings.pressDepth_m;
        if (low)
            touchedTable(felt.place.z());
        return enter(low ? Stage::scan : Stage::search, felt);
    }
    const double speed = m_settings.climbSpeed_m_per_s * steepness;
    const double into = m_settings.forceGain_m_per_Ns * (m_settings.force_N - pressure);
    m_reach.wish(speed * (steepness > 1e-6 ? Vec3(upward / upward.norm()) : Vec3(Vec3::Zero())) -
                 std::clamp(into, -0.04, 0.04) * outward);
}

void ScriptedTrainee::search(const Percept& felt) noexcept {
    if (m_lostFor_s > 0.8 || felt.place.z() < m_topHeight_m - kFallen_m)
        return enter(Stage::climb, felt);
    if (!m_steady) { // first reach the right pressure
        m_steady = since(felt) > kSteadying_s;
        if (m_steady)
            startTechnique(felt);
        return moveOnSurface(Vec2::Zero(), felt);
    }
    const SurfaceWish wish = m_technique->look(felt);
    moveOnSurface(wish.velocity, felt);
    if (wish.noHill) {
        touchedTable(felt.place.z());
        return enter(Stage::scan, felt);
    }
    if (wish.done)
        enter(Stage::approach, felt);
}

void ScriptedTrainee::startTechnique(const Percept& felt) noexcept {
    if (m_searched)
        m_technique->resume(felt);
    else
        m_technique->begin(felt);
    m_searched = true;
}

void ScriptedTrainee::approach(const Percept& felt) noexcept {
    const Vec2 goal = believedApex(felt);
    moveOnSurface(towards(goal, m_place, m_settings.sweepSpeed_m_per_s), felt);
    m_thereFor_s = (goal - m_place).norm() < kThere_m ? m_thereFor_s + Senses::kLook_s : 0.0;
    if (m_thereFor_s > kThere_s || since(felt) > 4.0)
        enter(Stage::settle, felt);
}

void ScriptedTrainee::settle(const Percept& felt) noexcept {
    moveOnSurface(Vec2::Zero(), felt);
    const bool firm = felt.touching || since(felt) > m_settings.settle_s + 1.5;
    if (since(felt) > m_settings.settle_s && firm)
        enter(Stage::press, felt);
}

void ScriptedTrainee::press(const Percept& felt) noexcept {
    moveOnSurface(Vec2::Zero(), felt);
    m_buttons = core::kButtonMark;
    if (since(felt) > kPress_s)
        enter(Stage::done, felt);
}

void ScriptedTrainee::moveFreely(const Vec2& goal, double height_m, double speed_m_per_s,
                                 const Percept& felt) noexcept {
    const Vec2 across = towards(goal, felt.place.head<2>(), speed_m_per_s);
    const double up = std::clamp(2.0 * (height_m - felt.place.z()), -speed_m_per_s, speed_m_per_s);
    m_reach.wish(Vec3(across.x(), across.y(), up));
}

void ScriptedTrainee::moveOnSurface(const Vec2& velocity_m_per_s, const Percept& felt) noexcept {
    double up = 0.0;
    if (m_settings.controlsForce) {
        const double wrong = m_settings.force_N - m_force.norm();
        // The felt slope says how fast the surface rises under a movement; the arm's own compliance does the
        // rest.
        const double rise = m_lean.z() > 0.2 ? -velocity_m_per_s.dot(m_lean.head<2>()) / m_lean.z() : 0.0;
        const double most = velocity_m_per_s.norm();
        up = std::clamp(kFollowing * rise, -most, most) -
             std::clamp(m_settings.forceGain_m_per_Ns * wrong, -0.04, 0.04);
    } else {
        if (!felt.touching)
            m_pressGoal_m -= 0.02 * Senses::kLook_s;
        up = std::clamp(2.0 * (m_pressGoal_m - m_reach.place().z()), -0.05, 0.05);
    }
    m_reach.wish(Vec3(velocity_m_per_s.x(), velocity_m_per_s.y(), up));
}

} // namespace chiron::operators
