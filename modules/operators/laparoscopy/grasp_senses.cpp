// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/laparoscopy/grasp_senses.h"
#include "cues/laparoscopy_cues.h"

#include <algorithm>

namespace chiron::operators {

using mechanisms::MarkovNoise;

GraspSenses::GraspSenses(const GraspPerceptionSettings& s, std::size_t hand,
                         const devices::WorkspaceMapping& place, std::uint64_t seed) noexcept
    : m_settings(s), m_hand(hand), m_map(place), m_random(core::Random::stream(seed, "laparoscopy/senses")),
      m_senses(s.hand, seed) {
    const auto make = [&](double sd, double time_s) {
        return MarkovNoise(sd, time_s, Senses::kLook_s, m_random);
    };
    m_tensionWeber = make(s.gaugeWeberFraction, s.gaugeNoiseTime_s);
    m_tensionFloor = make(s.gaugeFloorSd_N, s.gaugeNoiseTime_s);
    m_squeezeWeber = make(s.gaugeWeberFraction, s.gaugeNoiseTime_s);
    m_squeezeFloor = make(s.gaugeFloorSd_N, s.gaugeNoiseTime_s);
    m_length = make(s.lengthWeberFraction, s.lengthNoiseTime_s);
    m_thickness = make(s.lengthWeberFraction, s.lengthNoiseTime_s);
}

bool GraspSenses::feel(const mechanisms::HandPerception& real) noexcept {
    mechanisms::HandPerception seen = real;
    // If the picture is shown, sight locates the tip.
    seen.cues.objectShown = real.cues.exercise.of<core::LaparoscopyCues>().objectShown;
    if (!m_senses.feel(seen))
        return false;
    const Percept& felt = m_senses.percept();
    const core::LaparoscopyCues& screen = real.cues.exercise.of<core::LaparoscopyCues>();
    m_percept.time_s = felt.time_s;
    m_percept.cues = real.cues;
    m_percept.place = m_map.pointToW(felt.place);
    m_percept.force = m_map.wrenchToW({felt.force, core::Vec3::Zero()}).force;
    m_percept.tension_N =
        readBar(screen.tensionShown ? screen.tension_N : 0.0, m_tensionWeber, m_tensionFloor);
    // The same eye reads both bars of one percept, so both readings have the same error.
    m_percept.retraction_N =
        screen.retractionShown && screen.retraction_N > 0.0
            ? std::max(0.0, screen.retraction_N * (1.0 + m_tensionWeber.value()) + m_tensionFloor.value())
            : 0.0;
    m_percept.squeeze_N =
        readBar(screen.squeezeShown ? screen.squeeze_N[m_hand] : 0.0, m_squeezeWeber, m_squeezeFloor);
    m_percept.stretch_m =
        (screen.restLength_m + screen.stretch_m) * (1.0 + m_length.advance(m_random)) - screen.restLength_m;
    m_percept.flattening_m = seenFlattening(screen);
    return true;
}

/// The thickness is judged like any length.
double GraspSenses::seenFlattening(const core::LaparoscopyCues& screen) noexcept {
    const double wrong = m_thickness.advance(m_random);
    for (int i = 0; i < screen.bodies; ++i) {
        const core::BodyCue& body = screen.body[static_cast<std::size_t>(i)];
        if ((body.heldBy & (1U << m_hand)) != 0)
            return body.squeeze_m - wrong * (2.0 * body.radius_m - body.squeeze_m);
    }
    return 0.0;
}

/// An empty bar is always read as empty.
double GraspSenses::readBar(double shown_N, MarkovNoise& weber, MarkovNoise& floor) noexcept {
    const double read = shown_N * (1.0 + weber.advance(m_random)) + floor.advance(m_random);
    return shown_N > 0.0 ? std::max(0.0, read) : 0.0;
}

} // namespace chiron::operators
