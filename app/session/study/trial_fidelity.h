// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// What a participant really felt at one place in one trial, from the stored frames.
struct PlaceFidelity {
    int place = 0;
    double asked = 0.0; ///< the attribute's value there, SI
    /// The same as rendered, by regression of measured force (commanded, where a device measures none) on displacement or velocity: N/m, kg,
    /// N·s/m, μ; NaN where it was hardly touched.
    double rendered = std::numeric_limits<double>::quiet_NaN();
    double standardError = std::numeric_limits<double>::quiet_NaN();
    int contacts = 0;
    double contact_s = 0.0;
    double peakForce_N = 0.0;
    double meanSpeed_m_per_s = 0.0; ///< while it was touched
    double terminalForce_N = 0.0; ///< largest, averaged over contacts (Fu et al. 2017: what stiffness is judged by)
};

/// Where a mark lies beside the true apex of a sphere, along the axes of W: mark less apex.
struct ApexMark {
    double errorX_m = 0.0;
    double errorY_m = 0.0;
    double radius_m = 0.0;   ///< of the sphere
    bool inContact = false;  ///< it was touched when it was marked
    bool planned = false;    ///< drawn by the observer for planning: nothing was rendered, nobody felt anything
};

/// What a sitting in a window knows of a trial besides. Absent in scripted runs, and in trials of earlier versions.
struct TrialCircumstances {
    std::string language; ///< that the participant read: "en"
    std::string masking;  ///< kMasking...: what was heard meanwhile
    std::optional<std::uint64_t> answerTick; ///< of the session: the first key or click of the answer

    static constexpr const char* kMaskingNoise = "pink_noise";
    static constexpr const char* kMaskingOff = "off";            ///< the design has none, or somebody switched it off
    static constexpr const char* kMaskingSilent = "no_output";   ///< there is no sound output, so nothing was heard
    static constexpr const char* kMaskingChanged = "changed";    ///< switched on or off in the trial
    bool operator==(const TrialCircumstances&) const = default;
};

/// Device fidelity and exploration of one trial (psychophysics.md §3.2). What was not measured is NaN: all of it where nothing was rendered.
struct TrialFidelity {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    bool rendered() const { return duration_s >= 0.0; } ///< else `measured` and `contacts` say nothing

    double forceErrorRms_N = kNone; ///< commanded against measured, in contact; NaN with `measured` false
    bool measured = false;          ///< whether the device measures force
    /// Nothing was felt: the device renders no force. Forces are then the tissue's, and what compares them with what was asked is NaN.
    bool shown = false;
    double lateTicks = kNone;       ///< share
    double worstLateness_us = kNone;
    double saturated = kNone;       ///< share of contact ticks
    double duration_s = kNone;      ///< without pauses
    double paused_s = kNone;        ///< pauses within it, until force was back in full; NaN in trials stored before it was measured
    double peakForce_N = kNone;
    double meanSpeed_m_per_s = kNone; ///< of the tool over the whole trial, touching or not
    int contacts = 0;
    /// Largest |rendered/asked − 1| of places with a usable estimate; NaN where none has one, and for roughness and deformation, whose fits have
    /// no standard error.
    double stiffnessError = kNone;
    std::vector<PlaceFidelity> places;
    std::optional<ApexMark> apex; ///< of a study of the apex
    std::string outside;          ///< empty, or the first limit that was passed: the word stored as `spoiled`
    TrialCircumstances circumstances;
};

/// Without what is told of forces and of the values felt: those are no numbers, places, mark and the limit that was passed are left out.
TrialFidelity withoutForces(TrialFidelity fidelity);

/// As canonical JSON: keys sorted, no spaces; what is not a number is null.
std::string fidelityJson(const TrialFidelity& fidelity);
/// `paused_s` of a stored trial.
double pausedOf(const std::string& fidelityJson);
/// What a stored trial knows of its sitting.
TrialCircumstances circumstancesOf(const std::string& fidelityJson);
/// The mark of a stored trial; nothing where it holds none (another study, a time-out, something that cannot be read).
std::optional<ApexMark> apexMarkOf(const std::string& fidelityJson);

} // namespace chiron::session
