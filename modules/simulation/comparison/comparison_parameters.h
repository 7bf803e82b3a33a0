// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/attributes/object_attributes.h"
#include "simulation/yield.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::simulation {

/// The attribute in which the objects of a study differ (P2). Its value is in N/m, kg, s, m, 1 or N·s/m.
enum class ComparedAttribute : std::uint8_t { stiffness, mass, deformation, roughness, friction, viscosity };

/// Deliberate faults with which a study shows that it would notice them (psychophysics.md §6). They are
/// stored with the session, so that its replay computes the same forces.
enum class ComparisonControl : std::uint8_t {
    none,
    gain,     ///< every force 1.3 times as large
    swapped,  ///< another arrangement than the requested one
    constant, ///< every place has the reference's value
};
inline constexpr double kControlGain = 1.3;

/// Objects side by side that differ in one attribute (P2's studies). Each `present` command says what lies
/// where: a candidate (row of `values`) and an arrangement (which multiple, 0..2, of the difference lies at
/// each place).
struct ComparisonParameters {
    static constexpr int kMaxPlaces = 3;

    ComparedAttribute attribute = ComparedAttribute::stiffness;
    int places = 3;                            ///< 1..kMaxPlaces, from left (−x) to right
    std::vector<std::array<double, 3>> values; ///< [candidate][multiple], SI
    /// Multiple at each place; −1 where there is no place.
    std::vector<std::array<int, kMaxPlaces>> arrangements;
    ObjectAttributes object; ///< all other attributes, the same at all places

    double spacing_m = 0.040;   ///< from one place to the next, along x
    double padRadius_m = 0.009; ///< of the flat top of a pad
    /// How softly it falls off beyond: e metres further out it lies e²/(2·padEdge) lower.
    double padEdge_m = 0.004;
    /// How steeply it falls off at most, as height over way: from there on a cone. With a bound, roughness is
    /// read along the plane and fades out over the edge, so that the force is a gradient there, too, and the
    /// stiffness that is told counts the slope and how fast it turns. 0: without bound, as in sessions of
    /// earlier versions.
    double padSlope = 0.0;
    /// Height above its foot at which a tube or an object is taken hold of; a tube's rest length.
    double hookHeight_m = 0.030;
    double hookReach_m = 0.006; ///< how near the tip has to come to that point
    double hookLeave_m = 0.010; ///< how far it has to go away to let go, where nothing is stretched
    /// A tube that was let go is taken hold of again only after the tip has been where the tube cannot be
    /// slack (above its end, or far beside it), so that nobody who raises the tip takes hold by accident;
    /// false in sessions of earlier versions.
    bool leaveBeforeAgain = false;

    double exploreLimit_s = 30.0; ///< after this time the objects disappear; 0: no limit
    /// Counted after exploreLimit_s; then the trial ends without an answer; 0: no limit.
    double answerLimit_s = 20.0;
    double betweenTrials_s = 1.0;
    /// The first presentation of the session is a free one, in which the controls are tried: neither limit
    /// applies to it, and no button answers it.
    bool freeFirst = false;
    /// The tool's mark button, pressed while a place is touched, answers that place.
    bool buttonAnswers = false;
    bool buttonNeedsAll = false; ///< only once every place has been touched
    /// A place counts as touched once its object exerted this force; 0: at any touch, as in earlier versions.
    double probeAtLeast_N = 0.0;
    /// An object counts as touched only once it was lifted from the table (mass), where its weight is felt;
    /// false in sessions of earlier versions, in which pressing it onto the table was enough.
    bool touchedOnceLifted = false;
    bool adjusts = false; ///< a new `present` in a running trial changes the level
    ComparisonControl control = ComparisonControl::none;
    double maximumForce_N = 4.0; ///< the exercise's cap for the supervisor
    /// How hard an object may be pressed onto its bed beyond its weight (mass): the bed then gives way, and
    /// the object comes off the tool. By default never, as in sessions of earlier versions.
    YieldLaw yield;
    /// A tool that holds an object takes no other one, so that the yield force bounds all that is felt. Not
    /// so in sessions of earlier versions, which state no yield force.
    bool liftsOne() const noexcept { return std::isfinite(yield.force_N); }
    std::vector<std::string> cues; ///< "object": the places are drawn, all alike
};

/// Arguments of an `answer` command that are not answers.
inline constexpr std::uint16_t kAnswerSpoiled = 0xFFFF; ///< the trial ends unanswered
/// The study run is over: the session ends as completed.
inline constexpr std::uint16_t kAnswerFinish = 0xFFFE;

/// Says whether the attribute is felt by taking hold of something (a tube, an object) instead of on a pad.
constexpr bool isHooked(ComparedAttribute attribute) noexcept {
    return attribute == ComparedAttribute::stiffness || attribute == ComparedAttribute::mass;
}

/// Where a tip takes hold: a ball above the foot of a place, W.
struct GripZone {
    double height_m = 0.0; ///< of its centre
    double radius_m = 0.0;
};

/// Returns the zone that is drawn; a tip takes hold anywhere in it (ComparedObject). An object is taken hold
/// of within `hookReach_m` of its ring, all around. A tube is taken hold of only where it is slack, that is
/// below its end: the zone is the largest ball that lies in that part. Where neither is taken hold of, the
/// zone is a ball of no size.
constexpr GripZone gripZone(const ComparisonParameters& p) noexcept {
    if (!isHooked(p.attribute))
        return {};
    if (p.attribute == ComparedAttribute::mass)
        return {p.hookHeight_m, p.hookReach_m};
    return {p.hookHeight_m - 0.5 * p.hookReach_m, 0.5 * p.hookReach_m};
}

/// Height above the foot of a place (m, W) below which a tip above the foot lets go of the tube that it holds
/// (ComparedObject); 0 for an object that is not let go of at a height.
constexpr double letGoHeight_m(const ComparisonParameters& p) noexcept {
    return p.attribute == ComparedAttribute::stiffness ? p.hookHeight_m - p.hookLeave_m : 0.0;
}

/// x of a place in W (m); y is 0.
constexpr double placeX_m(const ComparisonParameters& p, int place) noexcept {
    return (place - 0.5 * (p.places - 1)) * p.spacing_m;
}

} // namespace chiron::simulation
