// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// What a participant actually felt at one place in one trial, from the stored frames.
struct PlaceFidelity {
    int place = 0;
    double asked = 0.0; ///< the attribute's value there, SI
    /// The rendered value, by regression of measured force (commanded, if the device measures none) on
    /// displacement or velocity: N/m, kg, N·s/m, μ; NaN if the place was hardly touched.
    double rendered = std::numeric_limits<double>::quiet_NaN();
    double standardError = std::numeric_limits<double>::quiet_NaN();
    int contacts = 0;
    double contact_s = 0.0;
    double peakForce_N = 0.0;
    double meanSpeed_m_per_s = 0.0; ///< during contact
    /// Largest force, averaged over contacts (Fu et al. 2017: the cue by which stiffness is judged).
    double terminalForce_N = 0.0;
};

/// The position of a mark relative to the true apex of a sphere, along the axes of W: mark minus apex.
struct ApexMark {
    double errorX_m = 0.0;
    double errorY_m = 0.0;
    double radius_m = 0.0;  ///< radius of the sphere
    bool inContact = false; ///< the sphere was in contact when it was marked
    /// Drawn from the observer model for planning: nothing was rendered and nobody felt anything.
    bool planned = false;
};

/// Further facts that a run in a window knows about a trial. Absent in scripted runs and in trials of earlier
/// versions.
struct TrialCircumstances {
    std::string language;                    ///< language of the participant: "en"
    std::string masking;                     ///< kMasking...: the sound heard during the trial
    std::optional<std::uint64_t> answerTick; ///< tick of the session at the first key or click of the answer

    static constexpr const char* kMaskingNoise = "pink_noise";
    /// The design has none, or somebody switched it off.
    static constexpr const char* kMaskingOff = "off";
    /// There is no sound output, so nothing was heard.
    static constexpr const char* kMaskingSilent = "no_output";
    static constexpr const char* kMaskingChanged = "changed"; ///< switched on or off during the trial
    bool operator==(const TrialCircumstances&) const = default;
};

/// Device fidelity and exploration of one trial (psychophysics.md §3.2). Values that were not measured are
/// NaN: all of them if nothing was rendered.
struct TrialFidelity {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    bool rendered() const { return duration_s >= 0.0; } ///< if false, `measured` and `contacts` are not valid

    double forceErrorRms_N = kNone; ///< commanded against measured, in contact; NaN with `measured` false
    bool measured = false;          ///< the device measures force
    /// Nothing was felt because the device renders no force. Forces are then the tissue's, and values that
    /// compare them with the requested ones are NaN.
    bool shown = false;
    double lateTicks = kNone; ///< fraction of the ticks
    double worstLateness_us = kNone;
    double saturated = kNone;  ///< fraction of the contact ticks
    double duration_s = kNone; ///< without pauses
    /// Pauses within the trial, until force was fully back; NaN in trials stored before this was measured.
    double paused_s = kNone;
    double peakForce_N = kNone;
    double meanSpeed_m_per_s = kNone; ///< of the tool over the whole trial, in and out of contact
    int contacts = 0;
    /// Largest |rendered/asked − 1| over places with a usable estimate; NaN if there is none, and for
    /// roughness and deformation, whose fits have no standard error.
    double stiffnessError = kNone;
    std::vector<PlaceFidelity> places;
    std::optional<ApexMark> apex; ///< only in a study of the apex
    /// The first limit that was exceeded, or empty: the word stored as `spoiled`.
    std::string outside;
    TrialCircumstances circumstances;
};

/// A copy without data about forces and felt values: those are NaN, and places, mark and the exceeded limit
/// are empty.
TrialFidelity withoutForces(TrialFidelity fidelity);

/// Canonical JSON: keys sorted, no spaces; NaN is null.
std::string fidelityJson(const TrialFidelity& fidelity);
/// `paused_s` of a stored trial.
double pausedOf(const std::string& fidelityJson);
/// The stored circumstances of a trial.
TrialCircumstances circumstancesOf(const std::string& fidelityJson);
/// The stored mark of a trial; empty if there is none (another study, a time-out, unreadable data).
std::optional<ApexMark> apexMarkOf(const std::string& fidelityJson);

} // namespace chiron::session
