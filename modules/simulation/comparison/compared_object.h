// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/comparison/comparison_parameters.h"
#include "simulation/objects/contact_yield.h"
#include "simulation/objects/object_contact.h"
#include "simulation/tube/tube_law.h"

#include <cstdint>

namespace chiron::simulation {

/// Response of the object at a place, on the tool.
/// Frame: W.
struct ComparedResponse {
    core::Vec3 force = core::Vec3::Zero();        ///< N
    core::Vec3 surfacePoint = core::Vec3::Zero(); ///< where to draw the tool
    double energy_J = 0.0;
    /// Square of a force that follows from the energy alone, for SceneOutput::load_N: squares of pads between
    /// which a tool is add up as their energies do. 0: no bound is known.
    double load_N2 = 0.0;
    double stiffness_N_per_m = 0.0;
    double damping_Ns_per_m = 0.0; ///< the part of the tool's budget that it uses
    /// Stretch of the tube, lift of the object (negative: pressed into its bed), depth in the pad.
    double displacement_m = 0.0;
    double depth_m = 0.0;     ///< below the pad's smooth surface, without roughness; signed
    bool touching = false;    ///< a force may act
    bool held = false;        ///< the tool has taken hold of it
    std::uint8_t contact = 0; ///< core::contact_bits of giving way
};

/// The object at one place, built from the exercises' laws:
///
/// - Stiffness: a tube fixed at its foot, taken hold of at its free end: T(x) along it, zero when slack
///   (tube_segment.h).
/// - Mass: f = (0, 0, k_b d − m g), d = max(0, m g/k_b − lift): an object on a soft bed, lifted; in the air,
/// its
///   weight alone.
/// - The others: a pad, ObjectContact on z = −max(0, ρ − R)²/(2e), a height field, so that f = −∇U in its
///   conservative part; flat where ρ < R and continuous everywhere. Beyond R + e s it goes on as a cone of
///   slope s, where `padSlope` states s: a hand that pushes from far outside meets at most √(1 + s²) times
///   the force of the same depth on the top.
///
/// A tool takes hold of a tube where it is slack within `hookReach_m` of its end, and lets go of it where it
/// is slack beyond `hookLeave_m`. With `leaveBeforeAgain` it then takes hold again only after it has been
/// farther from the foot than the tube is long. A tool takes hold of an object at its ring while the object
/// lies on its bed (weight and bed cancel); the object then keeps its offset from the tip. The object is let
/// go once it has been lifted (kLifted_m), then pressed onto its bed (kPress_N), and that press has ended.
/// Taking hold and letting go cause no step in force. An object that is pressed harder than
/// `ComparisonParameters::yield` allows comes off the tool: the bed gives way (yield.h), so the force on the
/// tool is never more than the yield force upwards and the weight downwards, however deep the tool goes. The
/// object can be changed while nothing touches it. The state consists of held, bristle, dent and yield.
/// Source: P2; models.md §2.2, §2.4, §8. Thread: haptic; allocates nothing.
class ComparedObject {
public:
    /// Force beyond its weight with which an object must be pressed to be let go ...
    static constexpr double kPress_N = 0.25;
    static constexpr double kLifted_m = 0.005; ///< ... once it has been lifted by this much

    /// Makes the object new and untouched. `value` is that of the attribute, SI; `seed` is that of its
    /// roughness.
    void set(const ComparisonParameters& parameters, int place, double value, std::uint64_t seed) noexcept;
    void clear() noexcept { m_present = false; }
    bool present() const noexcept { return m_present; }
    /// Out of contact, so that it can be changed unfelt.
    bool free() const noexcept { return !m_touching && !m_held; }
    bool held() const noexcept { return m_held; } ///< by the tool
    /// How many times the root of ComparedResponse::load_N2 the force of rough pads may be; 1: smooth.
    double steepest() const noexcept { return m_steepest; }

    /// Advances by one tick with the tool at `p`, moving with `v` (W, finite). `mostDamping_Ns_per_m` is the
    /// tool's damping budget. `mayLift`: the tool may take hold of an object to lift it.
    ComparedResponse respond(const core::Vec3& p, const core::Vec3& v,
                             double mostDamping_Ns_per_m = kUnboundedDamping, bool mayLift = true) noexcept;
    /// Advances by one tick without a tool.
    void release() noexcept;

private:
    ComparedResponse pull(const core::Vec3& p, const core::Vec3& v, double mostDamping_Ns_per_m) noexcept;
    ComparedResponse lift(const core::Vec3& p, const core::Vec3& v, double mostDamping_Ns_per_m,
                          bool mayLift) noexcept;
    ComparedResponse press(const core::Vec3& p, const core::Vec3& v, double mostDamping_Ns_per_m) noexcept;
    struct Top {
        double fall_m = 0.0;                        ///< below the flat part
        double slope = 0.0, turn_per_m = 0.0;       ///< of its fall outwards, and how fast that changes
        double rough = 1.0, roughSlope_per_m = 0.0; ///< share of the roughness, and how it changes outwards
    };
    Top topAt(double rho_m) const noexcept;
    void yieldTo(ComparedResponse& pressed) noexcept;
    void comeOff() noexcept;
    core::Vec3 ring() const noexcept { return m_foot + core::Vec3(0.0, 0.0, m_height_m); }

    ComparedAttribute m_attribute = ComparedAttribute::stiffness;
    core::Vec3 m_foot = core::Vec3::Zero();
    double m_height_m = 0.0, m_reach_m = 0.0, m_leave_m = 0.0;
    double m_radius_m = 0.0, m_edge_m = 1.0, m_slope = 0.0, m_steepest = 1.0;
    TubeLaw m_tube;
    double m_mass_kg = 0.0, m_bed_N_per_m = 1.0, m_bedDamping_Ns_per_m = 0.0;
    ContactYield m_yield; ///< of the bed
    ObjectContact m_pad;
    ObjectContactState m_state;
    core::Vec3 m_offset = core::Vec3::Zero();
    bool m_present = false;
    bool m_held = false;
    bool m_touching = false;
    bool m_lifted = false;
    bool m_pressed = false;
    bool m_leaveBeforeAgain = false; ///< of a tube
    bool m_awayFirst = false;        ///< after letting go, the tip has to leave before it takes hold again
};

} // namespace chiron::simulation
