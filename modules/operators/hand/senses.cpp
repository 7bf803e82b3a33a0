// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/hand/senses.h"

#include <cmath>

namespace chiron::operators {

using core::Vec2;
using core::Vec3;

Senses::Senses(const PerceptionSettings& s, std::uint64_t seed) noexcept
    : m_settings(s), m_random(core::Random::stream(seed, "sphere_apex/senses")) {
    const auto make = [&](double sd, double time_s) {
        return mechanisms::MarkovNoise(sd, time_s, kLook_s, m_random);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        m_bias[i] = make(s.positionBiasSd_m, s.positionBiasTime_s);
        m_quick[i] = make(s.positionNoiseSd_m, s.positionNoiseTime_s);
        m_vision[i] = make(s.visionNoiseSd_m, s.visionNoiseTime_s);
        m_floor[i] = make(s.forceFloorSd_N, s.forceNoiseTime_s);
    }
    m_weber = make(s.forceWeberFraction, s.forceNoiseTime_s);
    for (std::size_t i = 0; i < 2; ++i) {
        m_direction[i] = make(s.directionNoiseSd_rad, s.forceNoiseTime_s);
        m_directionBias[i] = make(s.directionBiasSd_rad, s.directionBiasTime_s);
    }
}

bool Senses::feel(const mechanisms::HandPerception& real) noexcept {
    m_sumForce += real.f_T_D;
    m_sumPlace += real.p_DT;
    if (++m_ticks < kTicksPerLook)
        return false;
    look(real);
    m_sumForce.setZero();
    m_sumPlace.setZero();
    m_ticks = 0;
    return true;
}

void Senses::look(const mechanisms::HandPerception& real) noexcept {
    Vec3 proprioception, vision;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        proprioception[axis] = m_bias[i].advance(m_random) + m_quick[i].advance(m_random);
        vision[axis] = m_vision[i].advance(m_random);
    }
    m_percept.time_s = real.time_s;
    m_percept.cues = real.cues;
    m_percept.objectSeen = real.cues.objectShown;
    m_percept.place = m_sumPlace / kTicksPerLook + (m_percept.objectSeen ? vision : proprioception);
    m_percept.seenApex = m_percept.objectSeen ? Vec2(real.p_DObject.head<2>()) : Vec2(Vec2::Zero());
    m_percept.force = feltForce(m_sumForce / kTicksPerLook);
    m_smooth += 0.1 * (m_percept.force - m_smooth);
    m_percept.touching = m_smooth.norm() > kTouch_N;
    const double pressure = m_percept.force.norm();
    const bool firm = m_percept.touching && pressure > 0.5 * kTouch_N;
    m_percept.slope = firm ? Vec2(m_percept.force.head<2>() / pressure) : Vec2(Vec2::Zero());
}

Vec3 Senses::feltForce(const Vec3& real) noexcept {
    const double weber = m_weber.advance(m_random);
    std::array<double, 2> angle{};
    for (std::size_t i = 0; i < 2; ++i)
        angle[i] = m_direction[i].advance(m_random) + m_directionBias[i].advance(m_random);
    const Vec3 floor(m_floor[0].advance(m_random), m_floor[1].advance(m_random),
                     m_floor[2].advance(m_random));
    const double size = real.norm();
    if (!(size > 1e-9))
        return floor;
    // Two axes across the force, the first towards x (or towards y if the force is along x).
    const Vec3 along = real / size;
    const Vec3 towards = std::abs(along.x()) < 0.9 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    const Vec3 first = (towards - towards.dot(along) * along).normalized();
    const Vec3 second = along.cross(first);
    const Vec3 turned = (along + std::tan(angle[0]) * first + std::tan(angle[1]) * second).normalized();
    return size * (1.0 + weber) * turned + floor;
}

} // namespace chiron::operators
