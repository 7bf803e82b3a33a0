// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/random.h"
#include "operators/hand/senses.h"

namespace chiron::operators {

/// What a technique wants its hand to do over the surface until the next look; the operator adds the
/// pressing.
struct SurfaceWish {
    core::Vec2 velocity = core::Vec2::Zero(); ///< across, m/s
    bool done = false;                        ///< content with estimate()
    bool noHill = false;                      ///< it felt flat: this is the table
};

/// How a trainee finds the apex once it is on top of something. Works on percepts alone. Haptic thread, no
/// allocation.
class ApexTechnique {
public:
    ApexTechnique() = default;
    ApexTechnique(const ApexTechnique&) = delete;
    ApexTechnique& operator=(const ApexTechnique&) = delete;
    virtual ~ApexTechnique() = default;
    /// A new attempt, from here.
    virtual void begin(const Percept& felt) noexcept = 0;
    /// On again after having slid off, from here. By default a new attempt.
    virtual void resume(const Percept& felt) noexcept { begin(felt); }
    virtual SurfaceWish look(const Percept& felt) noexcept = 0;
    /// Where it would mark now, in its own felt coordinates.
    virtual core::Vec2 estimate() const noexcept = 0;
};

/// Velocity that brings a felt place to a goal: proportional near it, at most
/// `speed`.
core::Vec2 towards(const core::Vec2& goal, const core::Vec2& place, double speed_m_per_s) noexcept;

} // namespace chiron::operators
