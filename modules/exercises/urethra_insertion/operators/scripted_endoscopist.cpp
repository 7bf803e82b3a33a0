// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/operators/scripted_endoscopist.h"

#include "core/units.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "modules/exercises/urethra_insertion/cues/procedure_stage.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

namespace {
// Habits that all operators share: assumptions.
constexpr double kForceSmoothing = 0.15;  ///< share per observation for smoothing the felt force: 0.07 s
constexpr double kPictureSmoothing = 0.2; ///< share per observation for smoothing what is seen
/// Force across to which it yields; above the mechanism's own force.
constexpr double kNoticed_N = 0.25;
constexpr double kNoticed_Nm = 0.008;        ///< the same for torque
constexpr double kGivingWay_m_per_s = 0.006; ///< greatest speed of yielding
constexpr double kNear_m = 0.012;            ///< no distance is taken to be shorter than this
/// Time without getting deeper, after which it goes back a little or pushes on.
constexpr double kStuck_s = 4.0;
constexpr double kProgress_m = 0.002;
constexpr double kBack_s = 0.8;
constexpr double kBack_m_per_s = 0.005;
constexpr double kHolding_s = 0.4; ///< keeps still for this time before it begins to search
/// Time without the landmark in the picture, after which it searches.
constexpr double kLost_s = 0.7;
constexpr double kCircle_s = 5.0; ///< duration of one circle of the search
/// Time with one landmark, after which it brings it nearer to the middle.
constexpr double kImpatient_s = 6.0;
constexpr double kLateBack = 0.25; ///< share of the dead zone, because the way out is known
constexpr double kAligned_rad = 0.07;
constexpr double kAligning_s = 4.0;

double beyond(double value, double threshold) noexcept {
    return value > threshold ? value - threshold : value < -threshold ? value + threshold : 0.0;
}
} // namespace

mechanisms::HandIntention ScriptedEndoscopist::decide(const mechanisms::HandPerception& seen) noexcept {
    if (seen.time_s <= 0.0)
        m_reach.start(seen.p_DT, seen.q_DT); // the hand begins where the instrument is
    if (m_senses.feel(seen))
        think(m_senses.percept());
    return m_reach.advance();
}

void ScriptedEndoscopist::think(const EndoscopePercept& felt) noexcept {
    smooth(felt);
    if (const Doing now = next(felt); now != m_doing)
        begin(now, felt);
    m_reach.wish(act(felt), felt.pitch_rad);
}

void ScriptedEndoscopist::smooth(const EndoscopePercept& felt) noexcept {
    m_along_N += kForceSmoothing * (felt.along_N - m_along_N);
    m_across_N += kForceSmoothing * (felt.across_N - m_across_N);
    m_pitchTorque_Nm += kForceSmoothing * (felt.pitchTorque_Nm - m_pitchTorque_Nm);
    m_yawTorque_Nm += kForceSmoothing * (felt.yawTorque_Nm - m_yawTorque_Nm);
    if (!felt.lumen.seen)
        return;
    m_up_rad += kPictureSmoothing * (felt.lumen.up_rad - m_up_rad);
    m_left_rad += kPictureSmoothing * (felt.lumen.left_rad - m_left_rad);
}

bool ScriptedEndoscopist::isStuck(const EndoscopePercept& felt) const noexcept {
    return m_settings.stopsBlind && felt.time_s - m_progress_s > kStuck_s;
}

bool ScriptedEndoscopist::drawsBack(const EndoscopePercept& felt) const noexcept {
    return m_settings.drawsBackAt_N > 0.0 && std::abs(m_across_N) > m_settings.drawsBackAt_N &&
           since(felt) > kBack_s;
}

ScriptedEndoscopist::Doing ScriptedEndoscopist::next(const EndoscopePercept& felt) const noexcept {
    if (felt.cues.phase != core::TrialPhase::running || felt.cues.force != core::ForceState::on)
        return Doing::rest;
    switch (felt.cues.exercise.of<simulation::EndoscopeCues>().stage) {
    case simulation::ProcedureStage::outside:
    case simulation::ProcedureStage::insertion:
        if (m_doing == Doing::back)
            return since(felt) < kBack_s ? Doing::back : Doing::insert;
        return m_doing == Doing::insert && (isStuck(felt) || drawsBack(felt)) ? Doing::back : Doing::insert;
    case simulation::ProcedureStage::inspection:
        return Doing::inspect;
    case simulation::ProcedureStage::withdrawal: {
        if (m_doing == Doing::withdraw || !m_settings.alignsBeforeWithdrawal)
            return Doing::withdraw;
        const EndoscopeWish left = align(felt, felt.depth_m);
        const bool aligned =
            std::hypot(left.pitch_rad_per_s, left.yaw_rad_per_s) < kAligned_rad * m_settings.turnGain_per_s;
        return m_doing == Doing::align && (aligned || since(felt) > kAligning_s) ? Doing::withdraw
                                                                                 : Doing::align;
    }
    case simulation::ProcedureStage::completed:
        break;
    }
    return Doing::rest;
}

void ScriptedEndoscopist::begin(Doing doing, const EndoscopePercept& felt) noexcept {
    m_doing = doing;
    m_began_s = felt.time_s;
    m_progress_s = felt.time_s;
    m_turns = false;
    if (doing == Doing::inspect) {
        m_neutralPitch_rad = m_reach.pitch_rad();
        m_neutralYaw_rad = m_reach.yaw_rad();
        m_landmarkBegan_s = felt.time_s;
        m_lastSeen_s = felt.time_s;
    }
}

EndoscopeWish ScriptedEndoscopist::act(const EndoscopePercept& felt) noexcept {
    EndoscopeWish wish;
    switch (m_doing) {
    case Doing::rest:
        break;
    case Doing::insert:
        wish = insert(felt);
        giveWay(wish);
        break;
    case Doing::back:
        wish.along_m_per_s = -kBack_m_per_s;
        giveWay(wish);
        break;
    case Doing::inspect:
        wish = inspect(felt);
        break;
    case Doing::align:
        wish = align(felt, felt.depth_m);
        break;
    case Doing::withdraw:
        wish = withdraw(felt);
        giveWay(wish);
        break;
    }
    return wish;
}

EndoscopeWish ScriptedEndoscopist::insert(const EndoscopePercept& felt) noexcept {
    m_way.keep(felt.depth_m, felt.pitch_rad, felt.pitch_rad + m_up_rad);
    if (felt.depth_m > m_deepest_m + kProgress_m) {
        m_deepest_m = felt.depth_m;
        m_progress_s = felt.time_s;
    }
    EndoscopeWish wish = steer(felt);
    wish.along_m_per_s *= ease();
    return wish;
}

EndoscopeWish ScriptedEndoscopist::steer(const EndoscopePercept& felt) noexcept {
    EndoscopeWish wish;
    if (!felt.lumen.seen) { // only wall is seen: turn to where the lumen was last
        wish.along_m_per_s = m_settings.stopsBlind ? 0.0 : m_settings.insertSpeed_m_per_s;
        wish.pitch_rad_per_s = m_settings.stopsBlind ? turning(m_up_rad) : 0.0;
        return wish;
    }
    const SeenThing lumen{true, m_up_rad, m_left_rad, std::max(felt.lumen.distance_m, kNear_m)};
    if (m_settings.steering == SteeringKind::centresLate)
        return centreLate(lumen);
    const double off = std::hypot(lumen.up_rad, lumen.left_rad);
    m_turns = off > m_settings.stopAngle_rad || (m_turns && off > 0.5 * m_settings.stopAngle_rad);
    if (!m_turns && m_settings.steering == SteeringKind::followsCurve)
        return followCurve(lumen);
    wish.along_m_per_s = m_turns ? 0.0 : m_settings.insertSpeed_m_per_s;
    if (m_turns || m_settings.steering == SteeringKind::centres)
        wish.pitch_rad_per_s = turning(lumen.up_rad);
    wish.yaw_rad_per_s = turning(lumen.left_rad);
    return wish;
}

/// The arc from the tip, tangential to the instrument, to the lumen has the curvature 2 sin(up)/distance.
EndoscopeWish ScriptedEndoscopist::followCurve(const SeenThing& lumen) const noexcept {
    const double curvature = m_settings.curveGain * 2.0 * std::sin(lumen.up_rad) / lumen.distance_m;
    EndoscopeWish wish;
    wish.along_m_per_s = std::min(m_settings.insertSpeed_m_per_s,
                                  m_settings.turnRate_rad_per_s / std::max(std::abs(curvature), 1.0));
    wish.pitch_rad_per_s = wish.along_m_per_s * ease() * curvature;
    wish.yaw_rad_per_s = turning(lumen.left_rad);
    return wish;
}

EndoscopeWish ScriptedEndoscopist::centreLate(const SeenThing& lumen) noexcept {
    EndoscopeWish wish;
    wish.along_m_per_s = m_settings.insertSpeed_m_per_s;
    if (!m_turns && std::abs(lumen.up_rad) > m_settings.deadZone_rad) {
        m_turns = true;
        m_turnsTo_rad = lumen.up_rad > 0.0 ? -m_settings.overshoot_rad : m_settings.overshoot_rad;
    }
    const double left = lumen.up_rad - m_turnsTo_rad;
    m_turns = m_turns && left * -m_turnsTo_rad > 0.02 * m_settings.overshoot_rad;
    wish.pitch_rad_per_s = m_turns ? turning(left) : 0.0;
    wish.yaw_rad_per_s = std::abs(lumen.left_rad) > m_settings.deadZone_rad ? turning(lumen.left_rad) : 0.0;
    return wish;
}

EndoscopeWish ScriptedEndoscopist::inspect(const EndoscopePercept& felt) noexcept {
    if (felt.cues.exercise.of<simulation::EndoscopeCues>().landmarksSeen != m_landmarksSeen) {
        m_landmarksSeen = felt.cues.exercise.of<simulation::EndoscopeCues>().landmarksSeen;
        m_landmarkBegan_s = felt.time_s;
        m_lookWithin_rad = m_settings.lookWithin_rad;
    }
    if (since(felt) < kHolding_s)
        return {};
    if (felt.time_s - m_landmarkBegan_s > kImpatient_s) {
        m_landmarkBegan_s = felt.time_s;
        m_lookWithin_rad *= 0.6;
    }
    if (felt.landmark.seen) {
        m_lastSeen_s = felt.time_s;
        const bool counted =
            m_settings.stopsWhenCounted && felt.cues.exercise.of<simulation::EndoscopeCues>().dwell > 0.0;
        return counted ? EndoscopeWish{} : turnTo(felt.landmark);
    }
    return felt.time_s - m_lastSeen_s > kLost_s ? search(felt) : EndoscopeWish{};
}

EndoscopeWish ScriptedEndoscopist::turnTo(const SeenThing& landmark) const noexcept {
    const double off = std::hypot(landmark.up_rad, landmark.left_rad);
    const double left = beyond(off, m_lookWithin_rad);
    const double rate =
        std::min(m_settings.lookRate_rad_per_s, m_settings.turnGain_per_s * left) / std::max(off, 1e-6);
    return {0.0, 0.0, rate * landmark.up_rad, rate * landmark.left_rad};
}

/// Turns in circles about the orientation at the beginning of the inspection; the circles grow over two
/// turns.
EndoscopeWish ScriptedEndoscopist::search(const EndoscopePercept& felt) const noexcept {
    const double t = felt.time_s - m_lastSeen_s - kLost_s;
    const double angle = 2.0 * core::kPi * t / kCircle_s;
    const double wide = m_settings.searchAngle_rad * std::min(1.0, 0.3 + t / (2.0 * kCircle_s));
    const double pitch = m_neutralPitch_rad + wide * std::sin(angle) - m_reach.pitch_rad();
    const double yaw = m_neutralYaw_rad + wide * std::cos(angle) - m_reach.yaw_rad();
    const double most = m_settings.lookRate_rad_per_s;
    return {0.0, 0.0, std::clamp(3.0 * pitch, -most, most), std::clamp(3.0 * yaw, -most, most)};
}

/// Turns back to how the instrument was held at `depth_m` on the way in. An operator who turns late does so
/// here, too.
EndoscopeWish ScriptedEndoscopist::align(const EndoscopePercept& felt, double depth_m) const noexcept {
    const WayMemory::Place way = m_way.at(depth_m);
    const double pitch = (way.kept ? way.pitch_rad : m_neutralPitch_rad) - felt.pitch_rad;
    const double threshold = kLateBack * m_settings.deadZone_rad;
    return {0.0, 0.0, turning(beyond(pitch, threshold)), turning(beyond(-felt.yaw_rad, threshold))};
}

EndoscopeWish ScriptedEndoscopist::withdraw(const EndoscopePercept& felt) const noexcept {
    const double speed = m_settings.withdrawSpeed_m_per_s * ease();
    EndoscopeWish wish = align(felt, felt.depth_m - speed * m_settings.anticipation_s);
    wish.along_m_per_s = -speed;
    const WayMemory::Place way = m_way.at(felt.depth_m);
    if (!way.kept || !felt.lumen.seen)
        return wish;
    // If the lumen appears higher than on the way in, the tip is too low by that angle times the distance.
    const double low_m =
        std::sin(felt.pitch_rad + m_up_rad - way.lumen_rad) * std::max(felt.lumen.distance_m, kNear_m);
    wish.across_m_per_s =
        std::clamp(m_settings.centringGain_per_s * low_m, -kGivingWay_m_per_s, kGivingWay_m_per_s);
    return wish;
}

void ScriptedEndoscopist::giveWay(EndoscopeWish& wish) const noexcept {
    wish.across_m_per_s += std::clamp(m_settings.reliefGain_m_per_Ns * beyond(m_across_N, kNoticed_N),
                                      -kGivingWay_m_per_s, kGivingWay_m_per_s);
    const double most = m_settings.turnRate_rad_per_s;
    wish.pitch_rad_per_s +=
        std::clamp(m_settings.reliefTurn_rad_per_Nms * beyond(m_pitchTorque_Nm, kNoticed_Nm), -most, most);
    wish.yaw_rad_per_s +=
        std::clamp(m_settings.reliefTurn_rad_per_Nms * beyond(m_yawTorque_Nm, kNoticed_Nm), -most, most);
}

double ScriptedEndoscopist::ease() const noexcept {
    const double most = std::max(std::abs(m_along_N) / m_settings.pushLimit_N,
                                 std::abs(m_across_N) / m_settings.acrossLimit_N);
    return std::clamp(2.0 * (1.0 - most), 0.0, 1.0);
}

double ScriptedEndoscopist::turning(double rad) const noexcept {
    return std::clamp(m_settings.turnGain_per_s * rad, -m_settings.turnRate_rad_per_s,
                      m_settings.turnRate_rad_per_s);
}

} // namespace chiron::operators
