// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/sphere_apex/operators/apex_technique.h"
#include "modules/exercises/sphere_apex/operators/sphere_apex_operator_settings.h"

namespace chiron::operators {

/// Moves from one random place to the next around where it came up, and remembers the position that felt
/// highest.
class WanderTechnique final : public ApexTechnique {
public:
    WanderTechnique(const SphereApexOperatorSettings& settings, std::uint64_t seed) noexcept;
    /// Defined beside the code that makes trainees, because a deleting destructor frees memory.
    ~WanderTechnique() override;
    void begin(const Percept& felt) noexcept override;
    void resume(const Percept& felt) noexcept override;
    SurfaceWish look(const Percept& felt) noexcept override;
    core::Vec2 estimate() const noexcept override { return m_highestPlace; }

private:
    void chooseGoal() noexcept;

    double m_radius_m;
    double m_speed_m_per_s;
    double m_time_s;
    core::Random m_random;
    core::Vec2 m_middle = core::Vec2::Zero();
    core::Vec2 m_goal = core::Vec2::Zero();
    core::Vec2 m_highestPlace = core::Vec2::Zero();
    double m_highest_m = 0.0;
    double m_began_s = 0.0;
    double m_goalBegan_s = 0.0;
};

} // namespace chiron::operators
