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

/// The grasper as the world sees it at one tick, W, SI.
struct HandlingTool {
    bool present = false; ///< false: nothing is touched, and what was held is let go
    core::Vec3 p_W = core::Vec3::Zero();
    core::Vec3 v_W = core::Vec3::Zero();
    double opening_m = 0.0; ///< between the tips of its jaws
    double mostDamping_Ns_per_m = kUnboundedDamping; ///< its budget
};

/// What the world answers to it.
struct HandlingAnswer {
    core::Vec3 force = core::Vec3::Zero();        ///< on the tool, N, W
    core::Vec3 surfacePoint = core::Vec3::Zero(); ///< where a tool that stays at the surface is drawn
    double energy_J = 0.0;                        ///< held by what the tool touches, above its rest; ≥ 0
    double stiffness_N_per_m = 0.0;               ///< largest of the active contacts
    double damping_Ns_per_m = 0.0;                ///< what all of them use of the tool's budget
    double bedDepth_m = 0.0;                      ///< deepest that the tool or an object presses the bed
    bool touching = false;
    std::uint8_t contact = 0; ///< core::contact_bits
    std::uint32_t events = 0; ///< kGrasped, kReleased, kSlipped, kDamaged
};

/// Loose bodies on a bed and one grasper among them (object handling). Deterministic; step() never allocates. The equations
/// are in this folder's README. Thread: haptic; begin() too.
class HandlingWorld {
public:
    static constexpr std::size_t kMaxBodies = ObjectHandlingTrial::kMaxObjects;
    static constexpr int kNone = -1;
    /// The rim of the field, from which bodies roll back, lies so far beyond the places (assumption).
    static constexpr double kRimBeyondPlaces_m = 0.025;
    /// An organ has to reach so far from the middle: a body whose middle is at the rim still lies on it whole.
    static double reachOfField_m(const ObjectHandlingParameters& p) noexcept {
        return p.placesRadius_m + kRimBeyondPlaces_m + p.radius_m;
    }

    /// `soft`: the organ that they lie on, which must outlive the world and is updated and asked by its owner; null: a plane.
    HandlingWorld(const ObjectHandlingParameters& parameters, SoftBed* soft) noexcept;

    void begin(const ObjectHandlingTrial& trial) noexcept; ///< the bodies lie down at rest
    void clear() noexcept;                                 ///< nothing is there any more

    HandlingAnswer step(const HandlingTool& tool) noexcept;

    int count() const noexcept { return static_cast<int>(m_count); }
    const LooseBody& body(std::size_t i) const noexcept { return m_bodies[i].it; }
    int held() const noexcept { return m_held; } ///< kNone: none
    const Squeeze& squeeze() const noexcept { return m_squeeze; } ///< of the jaws on what they hold

private:
    struct Body {
        LooseBody it;
        core::Vec3 load = core::Vec3::Zero(); ///< N, this tick, without bed and weight
        ObjectContactState tip;               ///< what the tip has done to it
        ContactYield yield;                   ///< under the tip
        double tipEnergy_J = 0.0;
        bool inside = false;     ///< the tip was inside it at the last tick
        bool embraced = false;   ///< the jaws are around it, or let it go there: the tip does not touch it
        bool touched = false;    ///< by the tip, this tick
        bool airborne = false;   ///< left the bed
        bool dropCounts = false; ///< let go in the air on purpose, and not landed yet: a hard landing is a drop
    };

    void updateGrip(const HandlingTool& tool, HandlingAnswer& answer) noexcept;
    int nearestInReach(const HandlingTool& tool) const noexcept;
    void takeHold(int body, const HandlingTool& tool) noexcept;
    void letGo(const HandlingTool& tool) noexcept;
    double slidShare() const noexcept;
    void squeezeHeld(const HandlingTool& tool, HandlingAnswer& answer) noexcept;
    void touchBody(Body& body, const HandlingTool& tool, HandlingAnswer& answer) noexcept;
    bool tipTouches(Body& body, double depth_m, const HandlingTool& tool) const noexcept;
    ContactPlace bedPlace(std::size_t who, const core::Vec3& p, const core::Vec3& v, double radius_m, double reach_m) noexcept;
    void layOnBed(std::size_t i) noexcept;
    void touchBed(const HandlingTool& tool, HandlingAnswer& answer) noexcept;
    void pushApart(HandlingAnswer& answer) noexcept;
    void carry(HandlingAnswer& answer) noexcept;
    void countEnergy(HandlingAnswer& answer) noexcept;
    void moveBodies(HandlingAnswer& answer) noexcept;
    bool isHeld(std::size_t i) const noexcept { return m_held == static_cast<int>(i); }

    ObjectHandlingParameters m_parameters;
    ObjectContact m_object;
    ObjectContact m_bed;
    ObjectContact m_bodyBed; ///< the same under a body: smooth and recovered
    SoftBed* m_soft;
    double m_organRest_J = 0.0; ///< of the organ while the tool touched nothing
    std::size_t m_count = 0;
    std::array<Body, kMaxBodies> m_bodies;
    ObjectContactState m_tipOnBed;
    ContactYield m_bedYield; ///< under the tip
    GraspLatch m_latch;
    GripSlide m_slide;
    core::Vec3 m_grip_m = core::Vec3::Zero(); ///< the held body's middle from the tip when it was grasped, kept in W
    int m_held = kNone;
    Squeeze m_squeeze;
    DampingBudget m_budget; ///< of the tick in hand
    bool m_damageArmed = true;
};

} // namespace chiron::simulation
