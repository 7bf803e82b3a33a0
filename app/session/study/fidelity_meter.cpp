// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/fidelity_meter.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

using simulation::ComparedAttribute;

namespace {

constexpr double kLate_ns = 0.5e6; ///< a tick that is later than this counts as late
constexpr double kSliding_m_per_s = 0.010;
constexpr double kDragging_m_per_s = 0.020; ///< at lower speeds, a hand's tremor would change the direction
/// The trail is this factor times as long as the bristle, and longer by this length.
constexpr double kTrail = 1.5, kTrail_m = 0.0005;
constexpr double kTaut_m = 0.0005;
constexpr double kAir_m = 0.002; ///< an object lifted higher than this lies on nothing
constexpr double kShortest_s = 0.005, kLongest_s = 5.0;
/// Share of the largest force allowed below which it is no longer near.
constexpr double kNotNear = 0.7;
constexpr double kUsableError = 0.05; ///< a fit with a larger relative standard error is not used

double norm(const std::array<double, 3>& v) {
    return std::hypot(v[0], v[1], v[2]);
}

/// True for attributes whose fit is exact enough to serve as a limit.
bool limited(ComparedAttribute attribute) {
    return attribute != ComparedAttribute::roughness && attribute != ComparedAttribute::deformation;
}

} // namespace

FidelityMeter::FidelityMeter(const simulation::ComparisonParameters& parameters,
                             const psychophysics::FidelityLimits& limits, bool mustTouchAll, bool shown)
    : m_parameters(parameters), m_limits(limits), m_mustTouchAll(mustTouchAll), m_shown(shown) {
    if (!m_parameters.adjusts)
        m_parameters.values.clear();
    for (std::size_t i = 0; i < kTimes; ++i) {
        m_time_s[i] = kShortest_s * std::pow(kLongest_s / kShortest_s, static_cast<double>(i) / (kTimes - 1));
        m_share[i] = 1.0 - std::exp(-core::kTickSeconds / m_time_s[i]);
    }
}

void FidelityMeter::begin(const std::vector<double>& asked) {
    m_asked = asked;
    m_places = {};
    m_ticks = m_paused = m_late = m_contactTicks = m_saturated = 0;
    m_last_ns = 0;
    m_worst_us = m_sumError2 = m_peak_N = m_sumSpeed = 0.0;
    m_touched = 0;
    m_measured = false;
    m_cameNearForceLimit = false;
}

void FidelityMeter::add(const FidelitySample& sample) {
    if (sample.phase != core::TrialPhase::running) {
        m_nearForceLimit = false;
        return;
    }
    if (m_last_ns != 0) {
        const double late_ns = static_cast<double>(sample.now_ns - m_last_ns) - 1e6;
        m_late += late_ns > kLate_ns ? 1 : 0;
        m_worst_us = std::max(m_worst_us, late_ns * 1e-3);
    }
    m_last_ns = sample.now_ns;
    if (sample.paused == 0) {
        ++m_ticks;
        m_sumSpeed += norm(sample.velocity_m_per_s);
    } else {
        ++m_paused;
    }
    m_touched = static_cast<std::uint8_t>(m_touched | sample.touched);
    m_measured = m_measured || (sample.measures && !m_shown);
    const std::array<double, 3>& force = m_shown           ? sample.tissue_N
                                         : sample.measures ? sample.measured_N
                                                           : sample.commanded_N;
    const auto at = static_cast<std::size_t>(sample.place);
    const bool present = at >= 1 && at <= m_places.size() && (sample.full || m_shown) && sample.paused == 0;
    for (std::size_t i = 0; i < m_places.size(); ++i)
        if (m_places[i].touching && !(present && i + 1 == at)) { // the contact has ended
            m_places[i].touching = false;
            m_places[i].sumTerminal_N += m_places[i].contactPeak_N;
        }
    noticeForce(present, norm(force));
    if (!present)
        return;
    if (m_parameters.adjusts && !m_places[at - 1].touching)
        noticeChange(at - 1, sample);
    addContact(m_places[at - 1], sample, force);
}

void FidelityMeter::noticeForce(bool present, double force_N) {
    const double share = m_nearForceLimit ? kNotNear : kNearForceLimit;
    m_nearForceLimit = present && force_N >= share * m_limits.peakForce_N;
    m_cameNearForceLimit = m_cameNearForceLimit || m_nearForceLimit;
}

void FidelityMeter::Place::forget() {
    line = {};
    bank = {};
}

/// Called at the beginning of a contact: discards the fit if the level was adjusted to another value in the
/// meantime.
void FidelityMeter::noticeChange(std::size_t place, const FidelitySample& sample) {
    const auto candidate = static_cast<std::size_t>(sample.candidate); // both count from 1
    const auto arrangement = static_cast<std::size_t>(sample.arrangement);
    if (place >= m_asked.size() || candidate < 1 || candidate > m_parameters.values.size() ||
        arrangement < 1 || arrangement > m_parameters.arrangements.size())
        return;
    const int multiple = m_parameters.arrangements[arrangement - 1][place];
    if (multiple < 0 || multiple > 2)
        return;
    const double value = m_parameters.values[candidate - 1][static_cast<std::size_t>(multiple)];
    if (value == m_asked[place])
        return;
    m_asked[place] = value;
    m_places[place].forget();
}

void FidelityMeter::addContact(Place& place, const FidelitySample& sample,
                               const std::array<double, 3>& force) {
    const double size_N = norm(force);
    if (!place.touching) {
        place.touching = true;
        place.contactPeak_N = 0.0;
        place.trail = {};
        ++place.contacts;
    }
    ++place.ticks;
    ++m_contactTicks;
    m_saturated += sample.saturated && !m_shown ? 1 : 0;
    place.peak_N = std::max(place.peak_N, size_N);
    place.contactPeak_N = std::max(place.contactPeak_N, size_N);
    place.sumSpeed += norm(sample.velocity_m_per_s);
    m_peak_N = std::max(m_peak_N, size_N);
    if (sample.measures && !m_shown)
        for (std::size_t i = 0; i < 3; ++i)
            m_sumError2 += (sample.measured_N[i] - sample.commanded_N[i]) *
                           (sample.measured_N[i] - sample.commanded_N[i]);
    fit(place, sample, force);
}

double FidelityMeter::trailLength_m(std::size_t place, double pressed_N) const {
    const double mu = place <= m_asked.size() ? std::max(0.0, m_asked[place - 1]) : 0.0;
    return kTrail_m + kTrail * mu * std::max(0.0, pressed_N) /
                          std::max(1.0, m_parameters.object.bristleStiffness_N_per_m);
}

void FidelityMeter::fit(Place& place, const FidelitySample& sample, const std::array<double, 3>& f) {
    const auto& v = sample.velocity_m_per_s;
    const double speed = std::hypot(v[0], v[1]);
    const double along = speed > 0.0 ? -(f[0] * v[0] + f[1] * v[1]) / speed : 0.0;
    // At its limit the force is determined by the device and no longer by the object; `saturated` counts
    // those ticks.
    const bool says = !sample.saturated && !m_shown;
    switch (m_parameters.attribute) {
    case ComparedAttribute::stiffness:
        if (says && sample.displacement_m > kTaut_m)
            place.line.add({sample.displacement_m, 1.0, v[2]}, norm(f));
        break;
    case ComparedAttribute::mass:
        if (says && sample.displacement_m > kAir_m + m_parameters.hookReach_m)
            place.line.add({1.0, 0.0, 0.0}, -f[2]);
        break;
    case ComparedAttribute::roughness:
        if (says && speed > kSliding_m_per_s)
            place.line.add({sample.depth_m, 1.0, v[2]}, f[2]);
        break;
    case ComparedAttribute::friction:
        place.trail.drag(v[0] * core::kTickSeconds, v[1] * core::kTickSeconds,
                         trailLength_m(sample.place, f[2]));
        if (says && place.trail.taut() && speed > kDragging_m_per_s)
            // Without a term for the speed: under constant pressure it would take over part of μ.
            place.line.add({f[2], 0.0, 0.0}, place.trail.against(f[0], f[1]));
        break;
    case ComparedAttribute::viscosity:
        if (says && speed > kSliding_m_per_s && sample.depth_m > 0.0005)
            place.line.add({speed, 1.0, 0.0}, along);
        break;
    case ComparedAttribute::deformation:
        for (std::size_t i = 0; i < kTimes; ++i) {
            if (says)
                place.bank[i].add({sample.depth_m, sample.depth_m - place.dent[i], 1.0}, f[2]);
            place.dent[i] += (sample.depth_m - place.dent[i]) * m_share[i];
        }
        break;
    }
}

PlaceFidelity FidelityMeter::summary(std::size_t index) const {
    const Place& place = m_places[index];
    PlaceFidelity out;
    out.place = static_cast<int>(index);
    out.asked = index < m_asked.size() ? m_asked[index] : 0.0;
    out.contacts = place.contacts;
    out.contact_s = static_cast<double>(place.ticks) * core::kTickSeconds;
    out.peakForce_N = place.peak_N;
    if (place.ticks > 0)
        out.meanSpeed_m_per_s = place.sumSpeed / static_cast<double>(place.ticks);
    if (place.contacts > 0)
        out.terminalForce_N =
            (place.sumTerminal_N + (place.touching ? place.contactPeak_N : 0.0)) / place.contacts;
    if (m_shown && place.ticks == 0) // nothing responded
        out.peakForce_N = out.terminalForce_N = TrialFidelity::kNone;
    if (m_parameters.attribute == ComparedAttribute::deformation) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < kTimes; ++i)
            if (const auto line = place.bank[i].solve(); line.good && line.residual < least) {
                least = line.residual;
                out.rendered = m_time_s[i];
            }
        return out;
    }
    const auto line = place.line.solve();
    if (!line.good)
        return out;
    double scale = 1.0;
    if (m_parameters.attribute == ComparedAttribute::mass)
        scale = 1.0 / core::kStandardGravity;
    out.rendered = line.slope[0] * scale;
    out.standardError = line.firstSd * scale;
    if (m_parameters.attribute == ComparedAttribute::roughness) {
        out.rendered = std::sqrt(line.residual / line.n) / m_parameters.object.stiffness_N_per_m;
        out.standardError = std::numeric_limits<double>::quiet_NaN();
    }
    return out;
}

TrialFidelity FidelityMeter::finish() const {
    TrialFidelity out;
    out.measured = m_measured;
    out.shown = m_shown;
    out.paused_s = static_cast<double>(m_paused) * core::kTickSeconds;
    const auto ticks = static_cast<double>(std::max<std::uint64_t>(1, m_ticks));
    const auto contact = static_cast<double>(m_contactTicks);
    if (m_measured && m_contactTicks > 0)
        out.forceErrorRms_N = std::sqrt(m_sumError2 / contact);
    out.lateTicks = static_cast<double>(m_late) / ticks;
    out.worstLateness_us = m_worst_us;
    if (m_contactTicks > 0 && !m_shown)
        out.saturated = static_cast<double>(m_saturated) / contact;
    out.duration_s = static_cast<double>(m_ticks) * core::kTickSeconds;
    out.peakForce_N = m_shown && m_contactTicks == 0 ? TrialFidelity::kNone : m_peak_N;
    out.meanSpeed_m_per_s = m_sumSpeed / ticks;
    for (std::size_t i = 0; i < std::min(m_asked.size(), m_places.size()); ++i) {
        PlaceFidelity place = summary(i);
        out.contacts += place.contacts;
        if (place.asked > 0.0 && place.standardError < kUsableError * std::abs(place.rendered))
            // fmax() returns the number if the other argument is NaN.
            out.stiffnessError = std::fmax(out.stiffnessError, std::abs(place.rendered / place.asked - 1.0));
        out.places.push_back(place);
    }
    out.outside = outsideOf(out);
    return out;
}

std::string FidelityMeter::outsideOf(const TrialFidelity& f) const {
    const auto every = static_cast<std::uint8_t>((1u << m_asked.size()) - 1u);
    if (m_mustTouchAll && (m_touched & every) != every)
        return "untouched";
    if (f.lateTicks > m_limits.lateTicks)
        return "late_ticks";
    if (f.saturated > m_limits.saturated)
        return "saturation";
    if (f.forceErrorRms_N > m_limits.forceErrorRms_N)
        return "force_error";
    if (limited(m_parameters.attribute) && f.stiffnessError > m_limits.stiffnessError)
        return "stiffness_error";
    if (f.peakForce_N > m_limits.peakForce_N)
        return "peak_force";
    return f.meanSpeed_m_per_s > m_limits.meanSpeed_m_per_s ? "speed" : "";
}

} // namespace chiron::session
