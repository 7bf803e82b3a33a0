// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/random.h"
#include "operators/hand/senses.h"

namespace chiron::operators {

/// The motion over the surface that a technique wants until the next observation; the operator adds the
/// pressing.
struct SurfaceWish {
    core::Vec2 velocity = core::Vec2::Zero(); ///< along the surface, m/s
    bool done = false;                        ///< satisfied with estimate()
    bool noHill = false;                      ///< the surface felt flat, so it is the table
};

/// How a trainee finds the apex once it is on top of something. Uses percepts only.
/// Thread: haptic; allocates nothing.
class ApexTechnique {
public:
    ApexTechnique() = default;
    ApexTechnique(const ApexTechnique&) = delete;
    ApexTechnique& operator=(const ApexTechnique&) = delete;
    virtual ~ApexTechnique() = default;
    /// Starts a new attempt from here.
    virtual void begin(const Percept& felt) noexcept = 0;
    /// Continues from here after the trainee slid off and came back on. Starts a new attempt by default.
    virtual void resume(const Percept& felt) noexcept { begin(felt); }
    virtual SurfaceWish look(const Percept& felt) noexcept = 0;
    /// The position that it would mark now, in its own felt coordinates.
    virtual core::Vec2 estimate() const noexcept = 0;
};

/// Velocity that brings a felt position to a goal: proportional to the distance near the goal, at most
/// `speed`.
core::Vec2 towards(const core::Vec2& goal, const core::Vec2& place, double speed_m_per_s) noexcept;

} // namespace chiron::operators
