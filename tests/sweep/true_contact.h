// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/session_setup.h"
#include "simulation/scene.h"

#include <cstddef>
#include <memory>

namespace chiron::tests {

/// Whether anything may act on a tool, by true distances that are computed here: from the level's content,
/// the plan of its trials, and where the scene says that its bodies are (objects, grips, the vertices of an
/// organ). What the scene found in contact, its depths, energies and stiffnesses are not read.
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
    /// From which clearance on the force has to be zero, m: rounding; on a mesh, how far a tool may be out of
    /// a sheet before the scene says so (contact_bits::kThrough), as touched_dome.cpp and soft_bed.cpp have
    /// it.
    virtual double tolerance_m() const { return 1e-9; }

    static constexpr double kNothing_m = 1.0; ///< clearance where there is nothing at all
};

/// For a scene that was made from this set-up and outlives what is returned; null for an exercise whose
/// geometry is not written here.
std::unique_ptr<TrueContact> trueContactOf(const session::SessionSetup& setup, simulation::IScene& scene);

} // namespace chiron::tests
