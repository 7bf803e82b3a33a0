// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/deformable/deformable_organ.h"
#include "simulation/scene.h"

#include <cstddef>

namespace chiron::tests {

/// Whether anything may act on a tool, by true distances that the exercise's SweepFacts compute: from the
/// level's content, the plan of its trials, and where the scene says that its bodies are (objects, grips, the
/// vertices of an organ). What the scene found in contact, its depths, energies and stiffnesses are not read.
class TrueContact {
public:
    TrueContact() = default;
    TrueContact(const TrueContact&) = delete;
    TrueContact& operator=(const TrueContact&) = delete;
    virtual ~TrueContact() = default;

    /// Once per tick, before the distances are asked for: what the scene was given, and what it answered.
    virtual void follow(const simulation::SceneInput&, const simulation::SceneOutput&) {}
    /// How far the tool is from everything that may act on it, m; ≤ 0: something may.
    virtual double clearance_m(std::size_t tool, const simulation::SceneInput& in,
                               const simulation::SceneOutput& out) = 0;
    /// Whether only friction still pulls at the tool: what it has let go of slides out of its jaws. This is
    /// no part of a law's potential, so its work is left out of what the law makes (models.md §2.4).
    virtual bool slides(std::size_t) const { return false; }
    /// From which clearance on the force has to be zero, m: rounding; on a mesh kMeshTolerance_m.
    virtual double tolerance_m() const { return 1e-9; }

    static constexpr double kNothing_m = 1.0; ///< clearance where there is nothing at all
    /// How far a tool may be out of a sheet before the scene says so (contact_bits::kThrough).
    static constexpr double kMeshTolerance_m = 2e-4;
};

/// Whether what a trial is about is there.
bool objectsPresent(const simulation::SceneOutput& out);

/// How far a rough surface may rise above its middle: 64 waves, rms √(2 · 64) (models.md §2.2).
double roughRise_m(double rms_m);

/// The organ of a scene at two rates; null where it has none.
const simulation::DeformableOrgan* organOf(simulation::IScene& scene);

/// Signed distance from the surface of an organ as it is shown in this tick, in its mesh's frame.
double distanceFrom_m(const simulation::DeformableOrgan& organ, const core::Vec3& p);

} // namespace chiron::tests
