// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace chiron::core {

/// The step of a laparoscopic exercise that the person has to do now; used by the screen's texts and by
/// scripted operators.
enum class LaparoscopyStep : std::uint8_t {
    none = 0,
    grasp = 1,    ///< take hold of the object (the end of the tube)
    stretch = 2,  ///< pull to the target
    hold = 3,     ///< keep it there
    handOver = 4, ///< the other instrument takes over
    lift = 5,     ///< off its support
    carry = 6,    ///< to the target
    place = 7,    ///< set the object down and release it
    done = 8,
    retract = 9, ///< draw back the tissue that lies over the object
};
inline constexpr int kLastLaparoscopyStep = 9;

/// A loose object.
/// Unit: m.
/// Frame: W.
struct BodyCue {
    std::array<double, 3> p_W{};
    std::array<double, 4> q_W{1.0, 0.0, 0.0, 0.0}; ///< w, x, y, z
    double radius_m = 0.0;                         ///< half the object's thickness
    std::uint8_t heldBy = 0;                       ///< one bit per tool
    double squeeze_m = 0.0;                        ///< by how much the jaws flatten it
};

/// The cues that the screen of a laparoscopic exercise shows in addition to the instruments. Cues that the
/// level hides stay zero (cue "object": bodies, tube and target; cue "bars": tension, squeeze and bands).
/// Trivially copyable.
/// Unit: SI.
/// Frame: W.
struct LaparoscopyCues {
    static constexpr std::size_t kMaxBodies = 4;
    static constexpr std::size_t kMaxGrips = 3;

    bool present = false;
    bool objectShown = false;
    LaparoscopyStep step = LaparoscopyStep::none;
    double dwell = 0.0; ///< 0..1: elapsed share of the holding time

    int bodies = 0;
    std::array<BodyCue, kMaxBodies> body{};

    // Tube: points along it from the base to the free end. Each is an anchor, an end or a point where an
    // instrument may grip.
    bool tube = false;
    int grips = 0;                                          ///< 0..kMaxGrips
    std::array<std::array<double, 3>, kMaxGrips> p_WGrip{}; ///< m
    std::array<double, kMaxGrips> gripAt{};                 ///< position along the rest length, 0 (base)
                                                            ///< .. 1 (free end)
    std::array<std::uint8_t, kMaxGrips> gripHeldBy{};       ///< one bit per tool
    std::array<bool, kMaxGrips> gripAnchored{};             ///< fixed to the floor
    double restLength_m = 0.0;
    double stretch_m = 0.0; ///< elongation of the whole tube beyond its rest length, 0 when slack
    bool torn = false;

    bool tensionShown = false; ///< cue "bars"
    double tension_N = 0.0;    ///< largest tension in the tube
    double bandLow_N = 0.0;    ///< target band; 0 if the task has none
    double bandHigh_N = 0.0;

    // A fold of tissue over the tube, which another instrument holds back.
    bool fold = false;
    std::array<double, 3> p_WFoldEdge{}; ///< where an instrument may grip it; m
    std::array<double, 3> p_WFoldBase{}; ///< where it is drawn back to; m
    std::uint8_t foldHeldBy = 0;         ///< one bit per tool
    bool foldOpen = false;               ///< held back far enough to reach what lies under it
    bool retractionShown = false;        ///< cue "bars"
    double retraction_N = 0.0;           ///< force with which the fold pulls
    double retractionLow_N = 0.0;        ///< from this pull on the way is free …
    double retractionHigh_N = 0.0;       ///< … and above this one the tissue is damaged

    bool targetShown = false; ///< target position of the object is shown
    std::array<double, 3> p_WTarget{};
    double targetRadius_m = 0.0;

    bool squeezeShown = false;                 ///< cue "bars"
    std::array<double, kMaxTools> squeeze_N{}; ///< squeezing force of each jaw
    double squeezeLimit_N = 0.0;               ///< 0: no limit
};

static_assert(std::is_trivially_copyable_v<LaparoscopyCues>);

} // namespace chiron::core
