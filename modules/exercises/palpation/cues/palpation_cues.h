// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace chiron::simulation {

inline constexpr std::size_t kMaxFindings = 8;   ///< most findings in one trial of a palpation
inline constexpr std::size_t kMaxShownLumps = 6; ///< most lumps in one trial

/// Something that a person reports to be there. It keeps its number (its index in the list) until it is
/// removed.
/// Unit: m.
/// Frame: W.
struct Finding {
    bool present = false;
    std::array<double, 3> p_W{}; ///< on the surface
    double radius_m = 0.0;       ///< 0: not stated
    std::uint8_t hardness = 0;   ///< 1..5; 0: not stated
    std::uint8_t confidence = 0; ///< 1..5; 0: not stated
};

/// Outcome of a finding, for use where the truth may be shown (playback, debrief).
enum class FindingOutcome : std::uint8_t { open, hit, falseAlarm };

/// Which map of the searched surface is shown: coverage (where it was pressed hard enough) or force.
enum class SurfaceMapKind : std::uint8_t { coverage, force };

/// A lump that the level shows (cue "object").
/// Unit: m.
/// Frame: W.
struct LumpCue {
    std::array<double, 3> p_W{}; ///< its centre, below the surface
    double radius_m = 0.0;
};

/// Contents of the screen of a palpation, apart from the hands. Values that the level does not show stay
/// zero. Trivially copyable.
/// Unit: SI.
/// Frame: W.
struct PalpationCues {
    bool present = false;

    std::array<Finding, kMaxFindings> finding{}; ///< the person's own, so always shown
    int selected = -1;                           ///< the finding to which further words refer

    bool asksSize = false; ///< what the level asks about a finding
    bool asksHardness = false;
    bool asksConfidence = false;

    int lumps = 0; ///< cue "object"
    std::array<LumpCue, kMaxShownLumps> lump{};

    bool coverageShown = false; ///< cue "coverage"
    double coverage = 0.0;      ///< 0..1: share of the search area that was pressed hard enough

    bool bandShown = false; ///< cue "bars"
    double bandLow_N = 0.0; ///< force band for pressing
    double bandHigh_N = 0.0;

    std::array<double, core::kMaxTools> depth_m{};  ///< of each finger's tip in the tissue; cue "bars"
    std::array<double, core::kMaxTools> lean_rad{}; ///< α, unlimited; cue "bars"
    /// One bit per tool: the device leans less than the force does.
    std::uint8_t leanSaturated = 0;

    bool squeezeShown = false;         ///< cue "bars", where the jaws squeeze tissue
    std::array<double, 2> squeeze_N{}; ///< of each hand's jaws
};

static_assert(std::is_trivially_copyable_v<PalpationCues>);

} // namespace chiron::simulation
