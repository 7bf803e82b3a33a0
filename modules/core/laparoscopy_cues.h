// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace chiron::core {

/// What a person is asked to do at this moment of a laparoscopic exercise, for the screen's words and scripted operators.
enum class LaparoscopyStep : std::uint8_t {
    none = 0,
    grasp = 1,    ///< take hold of the object (the end of the tube)
    stretch = 2,  ///< pull to the target
    hold = 3,     ///< keep it there
    handOver = 4, ///< the other instrument takes over
    lift = 5,     ///< off its support
    carry = 6,    ///< to the target
    place = 7,    ///< set down and let go
    done = 8,
    retract = 9, ///< draw the tissue back that lies over the object
};
inline constexpr int kLastLaparoscopyStep = 9;

/// A loose object. Places are W, m.
struct BodyCue {
    std::array<double, 3> p_W{};
    std::array<double, 4> q_W{1.0, 0.0, 0.0, 0.0}; ///< w, x, y, z
    double radius_m = 0.0;    ///< half its thickness
    std::uint8_t heldBy = 0;  ///< one bit a tool
    double squeeze_m = 0.0;   ///< by how much the jaws flatten it
};

/// What the screen of a laparoscopic exercise shows beside the instruments. What the level does not show stays zero (cue
/// "object": bodies, tube and target; cue "bars": tension, squeeze and bands). Trivially copyable; W, SI.
struct LaparoscopyCues {
    static constexpr std::size_t kMaxBodies = 4;
    static constexpr std::size_t kMaxGrips = 3;

    bool present = false;
    bool objectShown = false;
    LaparoscopyStep step = LaparoscopyStep::none;
    double dwell = 0.0; ///< 0..1: how much of the holding time is done

    int bodies = 0;
    std::array<BodyCue, kMaxBodies> body{};

    // Tube: places along it from the base to the free end. A place is an anchor, an end, or where an instrument may grip.
    bool tube = false;
    int grips = 0;                                               ///< 0..kMaxGrips
    std::array<std::array<double, 3>, kMaxGrips> p_WGrip{};      ///< m
    std::array<double, kMaxGrips> gripAt{};                      ///< 0 (base) .. 1 (free end), share of the rest length
    std::array<std::uint8_t, kMaxGrips> gripHeldBy{};            ///< one bit a tool
    std::array<bool, kMaxGrips> gripAnchored{};                  ///< fixed to the floor
    double restLength_m = 0.0;
    double stretch_m = 0.0;   ///< of the whole tube beyond its rest length, 0 when slack
    bool torn = false;

    bool tensionShown = false; ///< cue "bars"
    double tension_N = 0.0;    ///< largest in the tube
    double bandLow_N = 0.0;    ///< target band, 0 where the task has none
    double bandHigh_N = 0.0;

    // A fold of tissue over the tube, which a further instrument holds back.
    bool fold = false;
    std::array<double, 3> p_WFoldEdge{}; ///< m; where it may be gripped
    std::array<double, 3> p_WFoldBase{}; ///< m; where it is drawn back to
    std::uint8_t foldHeldBy = 0;         ///< one bit a tool
    bool foldOpen = false;               ///< it is held back far enough: what is under it can be reached
    bool retractionShown = false;        ///< cue "bars"
    double retraction_N = 0.0;           ///< its pull
    double retractionLow_N = 0.0;        ///< from here on the way is free …
    double retractionHigh_N = 0.0;       ///< … and above this the tissue suffers

    bool targetShown = false; ///< where something is to be brought
    std::array<double, 3> p_WTarget{};
    double targetRadius_m = 0.0;

    bool squeezeShown = false;                    ///< cue "bars"
    std::array<double, kMaxTools> squeeze_N{};    ///< of each jaw
    double squeezeLimit_N = 0.0;                  ///< 0: none
};

static_assert(std::is_trivially_copyable_v<LaparoscopyCues>);

} // namespace chiron::core
