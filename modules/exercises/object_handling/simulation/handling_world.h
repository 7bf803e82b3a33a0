// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/object_handling/simulation/loose_body.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "modules/exercises/object_handling/simulation/object_handling_plan.h"
#include "modules/exercises/object_handling/simulation/soft_bed.h"
#include "simulation/objects/contact_yield.h"
#include "simulation/objects/grasp.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace chiron::simulation {

/// State of the grasper in one tick, as the world needs it.
/// Unit: SI.
/// Frame: W.
struct HandlingTool {
    bool present = false; ///< false: it touches nothing, and what it held is let go
    core::Vec3 p_W = core::Vec3::Zero();
    core::Vec3 v_W = core::Vec3::Zero();
    double opening_m = 0.0;                          ///< between the tips of its jaws
    double mostDamping_Ns_per_m = kUnboundedDamping; ///< its damping budget
};

/// Response of the world to the grasper.
struct HandlingAnswer {
    core::Vec3 force = core::Vec3::Zero();        ///< on the tool, N, W
    core::Vec3 surfacePoint = core::Vec3::Zero(); ///< where a tool that stays at the surface is drawn
    /// Energy of the contacts that the tool takes part in, above that at rest; ≥ 0.
    double energy_J = 0.0;
    double stiffness_N_per_m = 0.0; ///< largest of the active contacts
    double damping_Ns_per_m = 0.0;  ///< the part of the tool's budget that all of them use
    /// Greatest depth to which the tool or an object presses the bed.
    double bedDepth_m = 0.0;
    bool touching = false;
    std::uint8_t contact = 0; ///< core::contact_bits
    std::uint32_t events = 0; ///< kGrasped, kReleased, kSlipped, kDamaged
};

/// Loose bodies on a bed and one grasper among them (object handling). Deterministic. This folder's README
/// has the equations. The checked range (kBeyondChecked outside it): no contact that the tool feels is deeper
/// than kCheckedContactDepth_m. These are the tip in a body and in the bed, the held body in the bed and in
/// its neighbours, and each jaw in the held body.
/// Thread: haptic, for step() and begin(); step() never allocates.
class HandlingWorld {
public:
    static constexpr std::size_t kMaxBodies = ObjectHandlingTrial::kMaxObjects;
    static constexpr int kNone = -1;
    /// Distance beyond the places of the rim of the field, from which bodies roll back (assumption).
    static constexpr double kRimBeyondPlaces_m = 0.025;
    /// How far an organ has to extend from the middle: a body whose centre is at the rim still lies entirely
    /// on it.
    static double reachOfField_m(const ObjectHandlingParameters& p) noexcept {
        return p.placesRadius_m + kRimBeyondPlaces_m + p.radius_m;
    }

    /// `soft` is the organ on which the bodies lie; it must outlive the world, and its owner updates and asks
    /// it. Null: the bed is a plane.
    HandlingWorld(const ObjectHandlingParameters& parameters, SoftBed* soft) noexcept;

    void begin(const ObjectHandlingTrial& trial) noexcept; ///< lays the bodies down at rest
    void clear() noexcept;                                 ///< removes everything

    HandlingAnswer step(const HandlingTool& tool) noexcept;

    int count() const noexcept { return static_cast<int>(m_count); }
    const LooseBody& body(std::size_t i) const noexcept { return m_bodies[i].it; }
    int held() const noexcept { return m_held; }                  ///< kNone: none
    const Squeeze& squeeze() const noexcept { return m_squeeze; } ///< of the jaws on the held object

private:
    struct Body {
        LooseBody it;
        core::Vec3 load = core::Vec3::Zero(); ///< N, in this tick, without bed and weight
        ObjectContactState tip;               ///< state of the tip's contact with it
        ContactYield yield;                   ///< state of its yielding under the tip
        double tipEnergy_J = 0.0;
        bool inside = false;   ///< the tip was inside it in the previous tick
        bool embraced = false; ///< the jaws are around it, or let it go there; the tip does not touch it
        bool touched = false;  ///< by the tip, in this tick
        bool airborne = false; ///< has left the bed
        /// Let go in the air on purpose and not landed yet: a hard landing counts as a drop.
        bool dropCounts = false;
    };

    void updateGrip(const HandlingTool& tool, HandlingAnswer& answer) noexcept;
    int nearestInReach(const HandlingTool& tool) const noexcept;
    void takeHold(int body, const HandlingTool& tool) noexcept;
    void letGo(const HandlingTool& tool) noexcept;
    double slidShare() const noexcept;
    void squeezeHeld(const HandlingTool& tool, HandlingAnswer& answer) noexcept;
    void touchBody(Body& body, const HandlingTool& tool, HandlingAnswer& answer) noexcept;
    bool tipTouches(Body& body, double depth_m, const HandlingTool& tool) const noexcept;
    ContactPlace bedPlace(std::size_t who, const core::Vec3& p, const core::Vec3& v, double radius_m,
                          double reach_m) noexcept;
    void layOnBed(std::size_t i) noexcept;
    void touchBed(const HandlingTool& tool, HandlingAnswer& answer) noexcept;
    static void checkRange(double depth_m, HandlingAnswer& answer) noexcept;
    void pushApart(HandlingAnswer& answer) noexcept;
    void carry(HandlingAnswer& answer) noexcept;
    void countEnergy(HandlingAnswer& answer) noexcept;
    void moveBodies(HandlingAnswer& answer) noexcept;
    bool isHeld(std::size_t i) const noexcept { return m_held == static_cast<int>(i); }

    ObjectHandlingParameters m_parameters;
    ObjectContact m_object;
    ObjectContact m_bed;
    ObjectContact m_bodyBed; ///< the same bed under a body: smooth and recovered
    SoftBed* m_soft;
    double m_organRest_J = 0.0; ///< energy of the organ while the tool touched nothing
    std::size_t m_count = 0;
    std::array<Body, kMaxBodies> m_bodies;
    ObjectContactState m_tipOnBed;
    ContactYield m_bedYield; ///< yielding of the bed under the tip
    GraspLatch m_latch;
    GripSlide m_slide;
    /// Offset of the held body's centre from the tip when it was grasped, kept in W.
    core::Vec3 m_grip_m = core::Vec3::Zero();
    int m_held = kNone;
    Squeeze m_squeeze;
    DampingBudget m_budget; ///< what is left in the present tick
    bool m_damageArmed = true;
};

} // namespace chiron::simulation
