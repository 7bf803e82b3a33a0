// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace chiron::simulation {

inline constexpr std::size_t kMaxFindings = 8;   ///< that one trial of a palpation takes
inline constexpr std::size_t kMaxShownLumps = 6; ///< lumps a trial may have

/// Something a person says is there; it keeps its number (its place in the list) until it is taken back. W, m.
struct Finding {
    bool present = false;
    std::array<double, 3> p_W{}; ///< on the surface
    double radius_m = 0.0;       ///< 0: not said
    std::uint8_t hardness = 0;   ///< 1..5; 0: not said
    std::uint8_t confidence = 0; ///< 1..5; 0: not said
};

/// What became of a finding, once the truth may be told (playback, debrief).
enum class FindingOutcome : std::uint8_t { open, hit, falseAlarm };

/// Which map of the searched surface is shown: where was pressed well, or how hard.
enum class SurfaceMapKind : std::uint8_t { coverage, force };

/// A lump that the level shows (cue "object"). W, m.
struct LumpCue {
    std::array<double, 3> p_W{}; ///< its centre, below the surface
    double radius_m = 0.0;
};

/// What the screen of a palpation shows beside the hands; what the level does not show stays zero. Trivially copyable; W, SI.
struct PalpationCues {
    bool present = false;

    std::array<Finding, kMaxFindings> finding{}; ///< the person's own, so always shown
    int selected = -1; ///< which of them further words are about

    bool asksSize = false; ///< what the level wants to be told of a finding
    bool asksHardness = false;
    bool asksConfidence = false;

    int lumps = 0; ///< cue "object"
    std::array<LumpCue, kMaxShownLumps> lump{};

    bool coverageShown = false; ///< cue "coverage"
    double coverage = 0.0;      ///< 0..1 of the search area pressed well

    bool bandShown = false; ///< cue "bars"
    double bandLow_N = 0.0; ///< how hard to press
    double bandHigh_N = 0.0;

    std::array<double, core::kMaxTools> depth_m{};    ///< of each finger's tip in the tissue; cue "bars"
    std::array<double, core::kMaxTools> lean_rad{};   ///< α, unlimited; cue "bars"
    std::uint8_t leanSaturated = 0;             ///< one bit a tool: the device leans less than the force does

    bool squeezeShown = false;           ///< cue "bars", where the jaws squeeze tissue
    std::array<double, 2> squeeze_N{};   ///< of each hand's jaw
};

static_assert(std::is_trivially_copyable_v<PalpationCues>);

} // namespace chiron::simulation
