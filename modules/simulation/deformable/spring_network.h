// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/result.h"
#include "core/tool_state.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace chiron::simulation {

using MeshTriangle = std::array<std::uint32_t, 3>; ///< vertex numbers, counter-clockwise from outside

/// A closed surface from which a network is built.
/// Unit: m.
/// Frame: the mesh's own.
struct SurfaceView {
    std::span<const core::Vec3> vertices;
    std::span<const MeshTriangle> triangles;
};

/// Material of the network.
/// Unit: SI.
struct SpringNetworkParameters {
    /// K: force per depth of a lasting press on the reference vertex; 20..5000.
    double stiffness_N_per_m = 400.0;
    double spread_m = 0.006;       ///< ℓ: how far a dent reaches around a press; 1..30 mm
    double mass_kg = 0.030;        ///< of the moving part; 1 g..1 kg
    double recoveryTime_s = 0.060; ///< τ: time constant of giving way and of recovering; 0..2 s
    double volumeKeeping = 0.7;    ///< q: share of the volume pressed in that bulges out elsewhere; 0..0.95
    /// A press moves the surface by no more than this (bone lies beyond); 1..30 mm.
    double deepest_m = 0.008;
    double step_s = 0.033; ///< one step of the slow model; 10..50 ms
};

/// One tool at the surface, as the network feels it: a spring of the local model between the tip and the
/// surface.
struct NetworkPush {
    std::uint32_t triangle = 0;
    std::array<double, 3> weights{};         ///< barycentric, ≥ 0, sum 1
    core::Vec3 normal = core::Vec3::UnitZ(); ///< outward, unit
    core::Vec3 p_Tool = core::Vec3::Zero();  ///< of the tip, m
    double stiffness_N_per_m = 500.0;        ///< k of the local model, > 0
};

/// A mass-spring network on a mesh's vertices, stepped implicitly: the deformable organ of the slow model.
///
/// The unknowns are displacements u from the rest shape. Every free vertex i has a mass m_i ∝ its area a_i, a
/// spring κ a_i to its rest position, springs σ = κ ℓ²/√3 to its neighbours (the membrane of reach ℓ of a
/// triangular lattice), and dampers of τ times these springs. All vertices share one volume spring on the
/// volume that is pressed in, V = Σ a_i n_i·u_i (to first order). Anchored vertices do not move. κ is chosen
/// so that a lasting press on the reference vertex gives way with K. A tool is a spring k between its tip p
/// and the surface's point s = Σ b_j x_j: pressed by d = n·(s − p) it pushes with a λ = k d between 0 and
/// K · deepest. Implicit Euler:
///
///   A δ = M v/h − K u + Σ (−n λ) b + g λ_v,   A = M/h² + (1 + τ/h) K,   u⁺ = u + δ,  v⁺ = δ/h
///
/// The contact is implicit, too: λ is the push at the end of the step. A tool that rests x deep in the rest
/// shape therefore meets the series of both springs, λ = x k K/(k + K), at any ratio of the two; the push at
/// the start of the step would diverge for k > K. Implicit Euler never adds energy to a linear network, so
/// the network is stable at any step size for any finite input (other input is ignored). A is constant and is
/// factored once (LDLᵀ, sparse) at set-up, so a step consists of seven substitutions and always costs the
/// same.
///
/// Source: Baraff & Witkin 1998 (implicit cloth), from memory; P2 "Passive Object Modeling" asks for a model
/// that "does not itself generate energy".
/// Thread: any for create(); all else on one thread at a time. Only create() allocates.
class SpringNetwork {
public:
    static constexpr std::size_t kMostVertices = 100'000; ///< of the mesh; the free ones set the cost
    static constexpr std::size_t kMostFree = 4'000;

    /// `anchored[i]`: vertex i does not move. `reference`: the vertex at which K is felt.
    /// Errors: badInput, naming the place and what was expected, on a mesh that is too large, has coordinates
    /// that are not finite or has no free vertices, an anchored reference, or parameters out of range.
    static core::Result<std::unique_ptr<SpringNetwork>> create(const SurfaceView& surface,
                                                               const std::vector<bool>& anchored,
                                                               std::uint32_t reference,
                                                               const SpringNetworkParameters& parameters);
    SpringNetwork(const SpringNetwork&) = delete;
    SpringNetwork& operator=(const SpringNetwork&) = delete;

    void reset() noexcept; ///< puts the network at rest in its rest shape
    /// Makes one step of step_s under up to kMaxTools presses. Returns the pushes λ (N) in that order, 0 for
    /// the rest.
    std::array<double, core::kMaxTools> step(std::span<const NetworkPush> pushes) noexcept;

    /// Displacement of a vertex of the mesh, m.
    core::Vec3 displacement(std::uint32_t vertex) const noexcept;
    double elasticEnergy_J() const noexcept; ///< of all springs, including the volume spring
    double kineticEnergy_J() const noexcept;
    double volumePressedIn_m3() const noexcept; ///< −V

    std::span<const core::Vec3> restVertices() const noexcept { return m_rest; }
    std::span<const MeshTriangle> triangles() const noexcept { return m_triangles; }
    std::size_t freeVertices() const noexcept { return m_mass.size(); }
    /// Number of entries of L, for benchmarks.
    std::size_t factorEntries() const noexcept { return m_lower.size(); }
    const SpringNetworkParameters& parameters() const noexcept { return m_parameters; }

private:
    SpringNetwork() = default;
    friend class SpringNetworkBuilder;

    struct Edge {
        std::uint32_t a; ///< numbers of the two unknowns
        std::uint32_t b;
    };
    /// Quantities of one press during a step.
    struct Contact {
        std::array<std::int32_t, 3> unknowns{}; ///< -1: anchored
        std::array<double, 3> weights{};
        core::Vec3 normal;
        double depth_m = 0.0; ///< after the free step
        double compliance = 0.0;
        double volume = 0.0; ///< n·(b·y): how much a press changes the volume
    };

    template <std::size_t Columns> void solve(double* x) const noexcept;
    void solveVolume() noexcept; ///< set-up: y ← A⁻¹ y
    void stiffnessTimes(const double* u, double* result) const noexcept;
    bool admit(const NetworkPush& push, Contact& contact) const noexcept;
    core::Vec3 at(const Contact& contact, const std::vector<double>& field) const noexcept;
    void freeStep() noexcept;
    void coupleContacts(std::span<Contact> contacts) noexcept;
    void solveContacts(std::span<const Contact> contacts,
                       std::array<double, core::kMaxTools>& pushes) const noexcept;
    void finishStep(std::span<const Contact> contacts,
                    const std::array<double, core::kMaxTools>& pushes) noexcept;

    SpringNetworkParameters m_parameters;
    std::vector<core::Vec3> m_rest;
    std::vector<MeshTriangle> m_triangles;
    std::vector<std::int32_t> m_unknownOf; ///< vertex → unknown in the factor's order; -1: anchored

    // Per unknown, in the factor's order; vectors take three entries each.
    std::vector<double> m_mass;   ///< kg
    std::vector<double> m_ground; ///< N/m: spring to the rest position, and to anchored neighbours
    std::vector<Edge> m_edges;
    double m_edgeStiffness = 0.0;         ///< σ, N/m
    std::vector<double> m_volumeGradient; ///< g = a_i n_i, m²
    std::vector<double> m_volumeResponse; ///< y = A⁻¹ g
    double m_volumeCompliance = 0.0;      ///< α, m⁶/J
    double m_volumeDiagonal = 1.0;        ///< α + g·y
    double m_largestPush_N = 0.0;         ///< K · deepest

    // L of L D Lᵀ by columns, without the unit diagonal.
    std::vector<std::uint32_t> m_columnBegin;
    std::vector<std::uint32_t> m_row;
    std::vector<double> m_lower;
    std::vector<double> m_inverseDiagonal;

    std::vector<double> m_u; ///< m
    std::vector<double> m_v; ///< m/s
    std::vector<double> m_delta;
    std::vector<double> m_columns; ///< A⁻¹ b of each contact, interleaved
    std::array<double, core::kMaxTools * core::kMaxTools> m_coupling{}; ///< of the contacts
    double m_volumeRest = 0.0;                                          ///< g·(u + free step)
};

} // namespace chiron::simulation
