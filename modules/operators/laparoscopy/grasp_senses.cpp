// SPDX-License-Identifier: GPL-3.0-or-later
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wtype-limits"
#pragma GCC diagnostic ignored "-Wtautological-compare"
#pragma GCC diagnostic ignored "-Wbool-compare"
#pragma GCC diagnostic ignored "-Wdiv-by-zero"
#pragma GCC diagnostic ignored "-Wempty-body"
#pragma GCC diagnostic ignored "-Wmisleading-indentation"
#pragma GCC diagnostic ignored "-Wdangling-else"
#pragma GCC diagnostic ignored "-Wimplicit-fallthrough"
#pragma GCC diagnostic ignored "-Waddress"
#pragma GCC diagnostic ignored "-Wnonnull"
#pragma GCC diagnostic ignored "-Wint-in-bool-context"
#pragma GCC diagnostic ignored "-Wbool-operation"
#pragma GCC diagnostic ignored "-Wreturn-type"
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-value"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-label"
#pragma GCC diagnostic ignored "-Wunused-result"
#ifndef CHIRON_MUTANT_SWITCH
#define CHIRON_MUTANT_SWITCH
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
namespace chiron_mutants {
inline unsigned char unread[4096];
inline unsigned char* openMarks() {
    const char* path = std::getenv("CHIRON_MUTANTS_REACHED");
    const int file = path ? ::open(path, O_RDWR) : -1;
    void* marks = file < 0 ? MAP_FAILED : ::mmap(nullptr, sizeof unread, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file >= 0)
        ::close(file);
    return marks == MAP_FAILED ? unread : static_cast<unsigned char*>(marks);
}
inline int chosen() {
    const char* number = std::getenv("CHIRON_MUTANT");
    return number ? std::atoi(number) : 0;
}
inline unsigned char* marks = openMarks();
inline int current = chosen();
constexpr bool on(int number) {
    if (__builtin_is_constant_evaluated())
        return false;
    if (marks)
        marks[number] = 1;
    return current == number;
}
}
#endif
#include "operators/laparoscopy/grasp_senses.h"

#include <algorithm>

namespace chiron::operators {

using mechanisms::MarkovNoise;

GraspSenses::GraspSenses(const GraspPerceptionSettings& s, std::size_t hand, const devices::WorkspaceMapping& place,
                         std::uint64_t seed) noexcept
    : m_settings(s), m_hand(hand), m_map(place), m_random(core::Random::stream(seed, "laparoscopy/senses")),
      m_senses(s.hand, seed) {
    const auto make = [&](double sd, double time_s) { return MarkovNoise(sd, time_s, Senses::kLook_s, m_random); };
    m_tensionWeber = make(s.gaugeWeberFraction, s.gaugeNoiseTime_s);
    m_tensionFloor = make(s.gaugeFloorSd_N, s.gaugeNoiseTime_s);
    m_squeezeWeber = make(s.gaugeWeberFraction, s.gaugeNoiseTime_s);
    m_squeezeFloor = make(s.gaugeFloorSd_N, s.gaugeNoiseTime_s);
    m_length = make(s.lengthWeberFraction, s.lengthNoiseTime_s);
    m_thickness = make(s.lengthWeberFraction, s.lengthNoiseTime_s);
}

bool GraspSenses::feel(const mechanisms::HandPerception& real) noexcept { if (chiron_mutants::on(26)) {
    mechanisms::HandPerception seen = real;
    seen.cues.objectShown = real.cues.laparoscopy.objectShown; // the picture is there: the tip is placed by sight
    if (!m_senses.feel(seen))
        return false;
    const Percept& felt = m_senses.percept();
    const core::LaparoscopyCues& screen = real.cues.laparoscopy;
    m_percept.time_s = felt.time_s;
    m_percept.cues = real.cues;
    m_percept.place = m_map.pointToW(felt.place);
    m_percept.force = m_map.wrenchToW({felt.force, core::Vec3::Zero()}).force;
    m_percept.tension_N = readBar(screen.tensionShown ? screen.tension_N : 0.0, m_tensionWeber, m_tensionFloor);
    // The same eye reads both bars at a look: what it mistakes of the one it mistakes of the other.
    m_percept.retraction_N = screen.retractionShown && screen.retraction_N > 0.0
                                 ? std::max(0.0, screen.retraction_N * (1.0 - m_tensionWeber.value()) + m_tensionFloor.value())
                                 : 0.0;
    m_percept.squeeze_N = readBar(screen.squeezeShown ? screen.squeeze_N[m_hand] : 0.0, m_squeezeWeber, m_squeezeFloor);
    m_percept.stretch_m = (screen.restLength_m + screen.stretch_m) * (1.0 + m_length.advance(m_random)) - screen.restLength_m;
    m_percept.flattening_m = seenFlattening(screen);
    return true;
} else if (chiron_mutants::on(37)) {
    mechanisms::HandPerception seen = real;
    seen.cues.objectShown = real.cues.laparoscopy.objectShown; // the picture is there: the tip is placed by sight
    if (!m_senses.feel(seen))
        return false;
    const Percept& felt = m_senses.percept();
    const core::LaparoscopyCues& screen = real.cues.laparoscopy;
    ;
    m_percept.cues = real.cues;
    m_percept.place = m_map.pointToW(felt.place);
    m_percept.force = m_map.wrenchToW({felt.force, core::Vec3::Zero()}).force;
    m_percept.tension_N = readBar(screen.tensionShown ? screen.tension_N : 0.0, m_tensionWeber, m_tensionFloor);
    // The same eye reads both bars at a look: what it mistakes of the one it mistakes of the other.
    m_percept.retraction_N = screen.retractionShown && screen.retraction_N > 0.0
                                 ? std::max(0.0, screen.retraction_N * (1.0 + m_tensionWeber.value()) + m_tensionFloor.value())
                                 : 0.0;
    m_percept.squeeze_N = readBar(screen.squeezeShown ? screen.squeeze_N[m_hand] : 0.0, m_squeezeWeber, m_squeezeFloor);
    m_percept.stretch_m = (screen.restLength_m + screen.stretch_m) * (1.0 + m_length.advance(m_random)) - screen.restLength_m;
    m_percept.flattening_m = seenFlattening(screen);
    return true;
} else {
    mechanisms::HandPerception seen = real;
    seen.cues.objectShown = real.cues.laparoscopy.objectShown; // the picture is there: the tip is placed by sight
    if (!m_senses.feel(seen))
        return false;
    const Percept& felt = m_senses.percept();
    const core::LaparoscopyCues& screen = real.cues.laparoscopy;
    m_percept.time_s = felt.time_s;
    m_percept.cues = real.cues;
    m_percept.place = m_map.pointToW(felt.place);
    m_percept.force = m_map.wrenchToW({felt.force, core::Vec3::Zero()}).force;
    m_percept.tension_N = readBar(screen.tensionShown ? screen.tension_N : 0.0, m_tensionWeber, m_tensionFloor);
    // The same eye reads both bars at a look: what it mistakes of the one it mistakes of the other.
    m_percept.retraction_N = screen.retractionShown && screen.retraction_N > 0.0
                                 ? std::max(0.0, screen.retraction_N * (1.0 + m_tensionWeber.value()) + m_tensionFloor.value())
                                 : 0.0;
    m_percept.squeeze_N = readBar(screen.squeezeShown ? screen.squeeze_N[m_hand] : 0.0, m_squeezeWeber, m_squeezeFloor);
    m_percept.stretch_m = (screen.restLength_m + screen.stretch_m) * (1.0 + m_length.advance(m_random)) - screen.restLength_m;
    m_percept.flattening_m = seenFlattening(screen);
    return true;
} }

/// Its thickness is judged as any length is.
double GraspSenses::seenFlattening(const core::LaparoscopyCues& screen) noexcept {
    const double wrong = m_thickness.advance(m_random);
    for (int i = 0; i < screen.bodies; ++i) {
        const core::BodyCue& body = screen.body[static_cast<std::size_t>(i)];
        if ((body.heldBy & (1U << m_hand)) != 0)
            return body.squeeze_m - wrong * (2.0 * body.radius_m - body.squeeze_m);
    }
    return 0.0;
}

/// An empty bar is read as empty.
double GraspSenses::readBar(double shown_N, MarkovNoise& weber, MarkovNoise& floor) noexcept {
    const double read = shown_N * (1.0 + weber.advance(m_random)) + floor.advance(m_random);
    return shown_N > 0.0 ? std::max(0.0, read) : 0.0;
}

} // namespace chiron::operators
