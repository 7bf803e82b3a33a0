// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/least_squares.h"
#include "psychophysics/study/study_design.h"
#include "session/study/fidelity_sample.h"
#include "session/study/sliding_trail.h"
#include "session/study/trial_fidelity.h"
#include "modules/exercises/comparison/simulation/comparison_parameters.h"

#include <array>
#include <vector>

namespace chiron::session {

/// Measures one trial from its ticks, one pass, as they are streamed or stored. Force is the device's measured one where it
/// measures, else the commanded one, and on a device that renders none the tissue's; f_z and z up; v̂ the direction of sliding:
///   stiffness    |f| = k x + c + b v_z over the stretch x                     → k
///   mass         −f_z in the air                                            → w/g
///   deformation  f_z = k d + k₁(d − q_τ) + c over 33 τ, least residual             → τ
///   roughness    rms of f_z = k d + c + b v_z while sliding, over the fixed k     → rms height
///   friction     −f_t·v̂ = μ f_z while sliding                                 → μ
///   viscosity    −f_t·v = b v² + c |v|                                        → b
/// Ticks with the force at its limit are in none of them: their share is a measure of its own.
/// Of stiffness, mass, viscosity and friction `stiffnessError` is a limit: those of a short stroke over a random surface,
/// and of a time constant, scatter by more than any sensible limit. Not for the haptic thread. Source: psychophysics.md §3.2; the
/// regressions are our choice.
class FidelityMeter {
public:
    /// `shown`: the device renders no force. What was rendered, how far it was off and saturation are then not measured.
    FidelityMeter(const simulation::ComparisonParameters& parameters, const psychophysics::FidelityLimits& limits, bool mustTouchAll, bool shown = false);

    /// A trial begins; `asked`: the value at each place, SI. Where a level is adjusted, a place's value is that of the presentation under
    /// which its last contact began (an object changes only while nobody touches it), and its fit is of contacts with that value alone.
    void begin(const std::vector<double>& asked);
    /// Ticks of the running phase count, others are passed over; those of a pause count as paused alone.
    void add(const FidelitySample& sample);
    /// What it was; `outside` by the limits.
    TrialFidelity finish() const;

private:
    static constexpr std::size_t kTimes = 33;
    struct Place {
        void forget(); ///< what was fitted
        core::LeastSquares<3> line;
        std::array<core::LeastSquares<3>, kTimes> bank;
        std::array<double, kTimes> dent{};
        int contacts = 0;
        std::uint64_t ticks = 0;
        double peak_N = 0.0, sumSpeed = 0.0, contactPeak_N = 0.0, sumTerminal_N = 0.0;
        bool touching = false;
        SlidingTrail trail;
    };
    void noticeChange(std::size_t place, const FidelitySample& sample);
    void addContact(Place& place, const FidelitySample& sample, const std::array<double, 3>& force);
    double trailLength_m(std::size_t place, double pressed_N) const; ///< `place` from 1
    void fit(Place& place, const FidelitySample& sample, const std::array<double, 3>& force);
    PlaceFidelity summary(std::size_t index) const;
    std::string outsideOf(const TrialFidelity& fidelity) const;

    simulation::ComparisonParameters m_parameters; ///< its table left out, unless a level is adjusted
    psychophysics::FidelityLimits m_limits;
    bool m_mustTouchAll;
    bool m_shown;
    std::array<double, kTimes> m_time_s{}, m_share{};
    std::vector<double> m_asked;
    std::array<Place, 3> m_places;
    std::uint64_t m_ticks = 0, m_paused = 0, m_late = 0, m_contactTicks = 0, m_saturated = 0;
    std::int64_t m_last_ns = 0;
    double m_worst_us = 0.0, m_sumError2 = 0.0, m_peak_N = 0.0, m_sumSpeed = 0.0;
    std::uint8_t m_touched = 0;
    bool m_measured = false;
};

} // namespace chiron::session
