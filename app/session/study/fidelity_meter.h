// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/least_squares.h"
#include "psychophysics/study/study_design.h"
#include "session/study/fidelity_sample.h"
#include "session/study/sliding_trail.h"
#include "session/study/trial_fidelity.h"
#include "simulation/comparison/comparison_parameters.h"

#include <array>
#include <vector>

namespace chiron::session {

/// Measures one trial in one pass over its ticks, streamed or stored. The force is the device's measured one
/// if it measures force, else the commanded one, and the tissue's on a device that renders none; f_z and z
/// point up; v̂ is the direction of sliding:
///   stiffness    |f| = k x + c + b v_z over the stretch x                     → k
///   mass         −f_z in the air                                            → w/g
///   deformation  f_z = k d + k₁(d − q_τ) + c over 33 τ, least residual             → τ
///   roughness    rms of f_z = k d + c + b v_z while sliding, over the fixed k     → rms height
///   friction     −f_t·v̂ = μ f_z while sliding                                 → μ
///   viscosity    −f_t·v = b v² + c |v|                                        → b
/// Ticks with the force at its limit are excluded from all fits: their share is a measure of its own.
/// `stiffnessError` is a limit for stiffness, mass, viscosity and friction; the estimates for a short stroke
/// over a random surface and for a time constant scatter more than any sensible limit. Source:
/// psychophysics.md §3.2; the regressions are our choice.
/// Thread: any except haptic.
class FidelityMeter {
public:
    /// `shown`: the device renders no force. The rendered value, its error and saturation are then not
    /// measured.
    FidelityMeter(const simulation::ComparisonParameters& parameters,
                  const psychophysics::FidelityLimits& limits, bool mustTouchAll, bool shown = false);

    /// Begins a trial; `asked`: the value at each place, SI. If a level is adjusted, the value of a place is
    /// that of the presentation during which its last contact began (an object changes only while nobody
    /// touches it), and the fit uses only contacts with that value.
    void begin(const std::vector<double>& asked);
    /// Adds a tick. Only ticks of the running phase count; those of a pause count only as paused.
    void add(const FidelitySample& sample);
    /// The result of the trial; `outside` names the limit that was exceeded.
    TrialFidelity finish() const;
    /// Share of the largest force that the limits allow in a trial from which on it is nearly reached.
    static constexpr double kNearForceLimit = 0.8;
    /// True while an object is touched with nearly the largest force that the limits allow in a trial. From
    /// the last tick added, in a trial or before the first one.
    bool nearForceLimit() const noexcept { return m_nearForceLimit; }
    /// True once this was so since begin(). Shown to a participant, nearForceLimit() would tell objects apart
    /// that are handled alike; this tells nothing of the object that is touched afterwards.
    bool cameNearForceLimit() const noexcept { return m_cameNearForceLimit; }

private:
    static constexpr std::size_t kTimes = 33;
    struct Place {
        void forget(); ///< discards the fitted data
        core::LeastSquares<3> line;
        std::array<core::LeastSquares<3>, kTimes> bank;
        std::array<double, kTimes> dent{};
        int contacts = 0;
        std::uint64_t ticks = 0;
        double peak_N = 0.0, sumSpeed = 0.0, contactPeak_N = 0.0, sumTerminal_N = 0.0;
        bool touching = false;
        SlidingTrail trail;
    };
    void noticeForce(bool present, double force_N);
    void noticeChange(std::size_t place, const FidelitySample& sample);
    void addContact(Place& place, const FidelitySample& sample, const std::array<double, 3>& force);
    double trailLength_m(std::size_t place, double pressed_N) const; ///< `place` from 1
    void fit(Place& place, const FidelitySample& sample, const std::array<double, 3>& force);
    PlaceFidelity summary(std::size_t index) const;
    std::string outsideOf(const TrialFidelity& fidelity) const;

    simulation::ComparisonParameters m_parameters; ///< without its table, unless a level is adjusted
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
    bool m_nearForceLimit = false, m_cameNearForceLimit = false;
};

} // namespace chiron::session
