// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "core/tool_state.h"
#include "simulation/deformable/spring_network.h"
#include "simulation/geometry/mesh/triangle_mesh.h"
#include "simulation/slow_model.h"
#include "simulation/two_rate/answer_blend.h"
#include "simulation/two_rate/slow_link.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace chiron::simulation {

/// The contact of one tool at the surface, as sent to the slow model. It holds plain numbers, because it
/// travels through a triple buffer.
struct OrganTouch {
    bool touching = false;
    std::uint32_t triangle = 0;
    std::array<double, 3> weights{}; ///< barycentric
    std::array<double, 3> normal{};  ///< outward, unit
    std::array<double, 3> p_Tool{};  ///< m, in the mesh's frame
    double stiffness_N_per_m = 0.0;  ///< of the local model there
};

using OrganTouches = std::array<OrganTouch, core::kMaxTools>;

/// Distance between the surface under the tools as it was shown at the tick of a request, and the slow
/// model's answer to that request (P2: "after a visual loop update, the haptic loop compares predicted
/// values"). It is the largest of all tools that touched; 0 where none did.
/// Unit: m.
struct PredictionError {
    double predicted_m = 0.0; ///< of the surface as shown, predicted and blended
    /// Error of the surface if the last answers had been held and blended without prediction.
    double held_m = 0.0;
};

/// A deformable organ at two rates (P2, "Haptic-Visual Graphic Integration"): a SpringNetwork that is asked
/// at 30 Hz beside the loop, and the moving surface that the loop renders from. Between the network's answers
/// the surface is predicted and blended.
///
/// The felt stiffness is as follows. The fast loop renders f = k d against the shown surface; the slow model
/// is told where the tool is and computes how far the organ gives way under that same spring. For a tool that
/// is held x deep in the rest shape:
///   at once (the surface has not reacted yet):    f = k x
///   from L ticks on:                             f = k (x − u),  u = x k/(k + K)  →  f = x k K/(k + K)
/// This is the series of the local stiffness k and the organ's K. A quick touch meets k, a lasting one the
/// series; in between, the blend leads from one to the other in B ticks, and then the network's τ applies. To
/// feel K_felt in the end, choose K = k K_felt/(k − K_felt), k > K_felt.
///
/// For rendering, position(), normal(), triangle(), largestDisplacement_m() and tree() are what a mesh
/// contact needs of a surface (geometry/mesh); only the vertices that are requested are blended.
/// Thread: the owner's for create(), and for restart() before a run (or haptic, in the tick); haptic for
/// update(), ask() and the surface; step() as ISlowModel says.
class DeformableOrgan final : public ISlowModel {
public:
    static constexpr bool kMoves = true; ///< a place of the surface moves from tick to tick

    struct Settings {
        SpringNetworkParameters network;
        TwoRateTiming timing;
        /// B, ticks over which an answer is blended in; at most timing.latency_ticks.
        std::uint64_t blend_ticks = 33;
        double prediction = 0.5; ///< γ, 0..1
    };

    /// Copies the mesh.
    /// Errors: those of SpringNetwork::create; badInput where B > L.
    static core::Result<std::unique_ptr<DeformableOrgan>> create(const TriangleMesh& mesh,
                                                                 const std::vector<bool>& anchored,
                                                                 std::uint32_t reference,
                                                                 const Settings& settings);
    ~DeformableOrgan() override;

    /// Puts the organ at rest from this tick on, for another trial. An answer that is still pending is
    /// received and discarded.
    void restart(std::uint64_t tick) noexcept;
    /// Call once per tick, before the surface is used: applies an answer that takes effect (then returns
    /// true: kSlowApplied) and sets the weights.
    bool update(std::uint64_t tick, SlowUpdate when) noexcept;
    /// Call once per tick, after the contacts are known: sends a request to the slow model if it is time.
    void ask(std::uint64_t tick, const OrganTouches& touches) noexcept;

    bool step() noexcept override;

    // The surface that is shown in this tick.
    core::Vec3 position(std::uint32_t vertex) const noexcept;
    core::Vec3 normal(std::uint32_t vertex) const noexcept; ///< unit
    const SurfaceTriangle& triangle(std::uint32_t index) const noexcept { return m_mesh.triangle(index); }
    const MeshTree& tree() const noexcept { return m_mesh.tree(); }
    double largestDisplacement_m() const noexcept { return m_largest_m; } ///< bound for this tick
    double elasticEnergy_J() const noexcept { return m_energy_J; }        ///< of the organ, blended, ≥ 0
    /// Of the last answer that took effect.
    const PredictionError& predictionError() const noexcept { return m_error; }

    const TriangleMesh& restMesh() const noexcept { return m_mesh; }
    const SpringNetwork& network() const noexcept { return *m_network; } ///< only while no step runs
    /// For tests only: an answer takes effect at once, unblended.
    void switchBlendingOffForTests() noexcept { m_blends = false; }

private:
    struct Request {
        std::uint32_t epoch = 0;
        OrganTouches touches{};
    };
    struct Answer {
        std::uint32_t epoch = 0;
        double largest_m = 0.0;
        double energy_J = 0.0;
    };
    struct Moved { ///< a vertex according to one answer
        core::Vec3 displacement = core::Vec3::Zero();
        core::Vec3 normal = core::Vec3::UnitZ();
    };
    using Link = SlowLink<Request, Answer>;

    DeformableOrgan(const TriangleMesh& mesh, std::unique_ptr<SpringNetwork> network,
                    const Settings& settings);
    Answer solve(std::uint64_t number, const Request& request) noexcept;
    void setWeights(std::uint64_t tick) noexcept;
    /// Compares the answer with the surface that was shown when it was requested.
    void compare(std::uint64_t number) noexcept;
    /// Displacement of the surface under a touch according to one answer.
    core::Vec3 displacementOf(std::uint64_t number, const OrganTouch& touch) const noexcept;

    /// Contribution of one answer to the shown surface.
    struct Share {
        double weight = 0.0;
        const Moved* moved = nullptr; ///< null: the rest shape
    };

    TriangleMesh m_mesh;
    Settings m_settings;
    // Tick.
    AnswerBlend m_blend;
    std::uint32_t m_epoch = 0;
    std::array<Share, 3> m_shares{};
    std::array<Answer, Link::kSlots> m_answers{};
    double m_largest_m = 0.0;
    double m_energy_J = 0.0;
    OrganTouches m_asked{}; ///< of the last request
    /// Displacements under those touches, as shown at the request.
    std::array<core::Vec3, core::kMaxTools> m_shown{};
    std::array<core::Vec3, core::kMaxTools> m_held{}; ///< the same without prediction
    PredictionError m_error;
    bool m_moves = false; ///< the surface differs from the rest shape
    bool m_blends = true;
    Link m_link;
    /// The model writes one of them while the tick reads the others.
    std::array<std::vector<Moved>, Link::kSlots> m_slots;
    // Slow model.
    std::unique_ptr<SpringNetwork> m_network;
    std::uint32_t m_modelEpoch = 0;
    std::vector<CornerAngles> m_angles;
    std::vector<core::Vec3> m_places;
    std::vector<core::Vec3> m_normals;
};

} // namespace chiron::simulation
