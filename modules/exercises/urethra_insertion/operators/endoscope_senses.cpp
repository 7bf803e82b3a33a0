// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/operators/endoscope_senses.h"

#include "mechanisms/spherical_joint.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::Vec3;
using mechanisms::MarkovNoise;

EndoscopeSenses::EndoscopeSenses(const EndoscopePerceptionSettings& s, std::uint64_t seed) noexcept
    : m_settings(s), m_random(core::Random::stream(seed, "urethra_insertion/senses")) {
    const auto make = [&](double sd, double time_s) { return MarkovNoise(sd, time_s, kLook_s, m_random); };
    for (std::size_t i = 0; i < 2; ++i) {
        m_angleBias[i] = make(s.angleBiasSd_rad, s.angleBiasTime_s);
        m_angleQuick[i] = make(s.angleNoiseSd_rad, s.angleNoiseTime_s);
        m_picture[i] = make(s.pictureNoiseSd_rad, s.pictureNoiseTime_s);
        m_floor[i] = make(s.forceFloorSd_N, s.forceNoiseTime_s);
        m_torqueFloor[i] = make(s.torqueFloorSd_Nm, s.forceNoiseTime_s);
    }
    m_distance = make(s.distanceWeberFraction, s.pictureNoiseTime_s);
    m_depth = make(s.depthNoiseSd_m, s.depthNoiseTime_s);
    m_weber = make(s.forceWeberFraction, s.forceNoiseTime_s);
    m_torqueWeber = make(s.torqueWeberFraction, s.forceNoiseTime_s);
    m_direction = make(s.directionNoiseSd_rad, s.forceNoiseTime_s);
    m_directionBias = make(s.directionBiasSd_rad, s.directionBiasTime_s);
}

bool EndoscopeSenses::feel(const mechanisms::HandPerception& real) noexcept {
    m_sumForce += real.f_T_D;
    m_sumTorque += real.t_T_D;
    if (++m_ticks < kTicksPerLook)
        return false;
    look(real);
    m_sumForce.setZero();
    m_sumTorque.setZero();
    m_ticks = 0;
    return true;
}

void EndoscopeSenses::look(const mechanisms::HandPerception& real) noexcept {
    const mechanisms::EndoscopeAngles held = mechanisms::SphericalJoint::anglesOf(real.q_DT);
    m_percept.time_s = real.time_s;
    m_percept.cues = real.cues;
    m_percept.pitch_rad = held.pitch + m_angleBias[0].advance(m_random) + m_angleQuick[0].advance(m_random);
    m_percept.yaw_rad = held.yaw + m_angleBias[1].advance(m_random) + m_angleQuick[1].advance(m_random);
    feelForces(held.pitch, held.yaw);

    const simulation::EndoscopeCues& cues = real.cues.exercise.of<simulation::EndoscopeCues>();
    const double unmarked = cues.guided ? 1.0 : m_settings.unmarkedFactor;
    m_percept.depth_m = cues.depth_m + m_depth.advance(m_random);
    for (MarkovNoise& noise : m_picture)
        noise.advance(m_random);
    m_distance.advance(m_random);
    const Vec3 lumen(cues.toLumen_T[0], cues.toLumen_T[1], cues.toLumen_T[2]);
    const Vec3 landmark(cues.toLandmark_T[0], cues.toLandmark_T[1], cues.toLandmark_T[2]);
    m_percept.lumen = cues.pictureShown ? see(lumen, cues.lumenDistance_m, unmarked) : SeenThing{};
    m_percept.landmark =
        cues.pictureShown && cues.landmarkShown ? see(landmark, landmark.norm(), unmarked) : SeenThing{};
}

/// `to_T` is the direction to it in T, which looks along −z with x to the right and y up; zero: it is not in
/// the picture.
SeenThing EndoscopeSenses::see(const Vec3& to_T, double distance_m, double unmarked) noexcept {
    SeenThing thing;
    thing.seen = to_T.squaredNorm() > 0.0;
    if (!thing.seen)
        return thing;
    thing.up_rad = std::atan2(to_T.y(), -to_T.z()) + unmarked * m_picture[0].value();
    thing.left_rad = std::atan2(-to_T.x(), -to_T.z()) + unmarked * m_picture[1].value();
    thing.distance_m = distance_m * std::max(0.2, 1.0 + m_distance.value());
    return thing;
}

void EndoscopeSenses::feelForces(double pitch_rad, double yaw_rad) noexcept {
    const mechanisms::SphericalJoint joint({pitch_rad, yaw_rad, 0.0});
    const Vec3 force = m_sumForce / kTicksPerLook;
    const Vec3 torque = m_sumTorque / kTicksPerLook;
    const double size = 1.0 + m_weber.advance(m_random);
    const double turn = m_direction.advance(m_random) + m_directionBias.advance(m_random);
    const double along = force.dot(joint.view_D()), across = force.dot(joint.yawAxis_D());
    m_percept.along_N =
        size * (along * std::cos(turn) - across * std::sin(turn)) + m_floor[0].advance(m_random);
    m_percept.across_N =
        size * (along * std::sin(turn) + across * std::cos(turn)) + m_floor[1].advance(m_random);
    const double torqueSize = 1.0 + m_torqueWeber.advance(m_random);
    m_percept.pitchTorque_Nm = torqueSize * torque.x() + m_torqueFloor[0].advance(m_random);
    m_percept.yawTorque_Nm = torqueSize * torque.dot(joint.yawAxis_D()) + m_torqueFloor[1].advance(m_random);
}

} // namespace chiron::operators
