// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/sphere_apex/operators/apex_fit.h"
#include "modules/exercises/sphere_apex/operators/apex_technique.h"
#include "modules/exercises/sphere_apex/operators/sphere_apex_operator_settings.h"

namespace chiron::operators {

/// Sweeps to and fro a short way along x, then along y, over the believed apex. It fits felt slope against
/// felt position (in both directions, so that friction and its own lag cancel; ApexFit) and continues from
/// where the slope crosses zero. The second and later crosses are two thirds as wide. It stops after
/// `crosses` of them if the last moved the apex by less than 5 mm, otherwise after one more.
class SlopeCrossingsTechnique final : public ApexTechnique {
public:
    explicit SlopeCrossingsTechnique(const SphereApexOperatorSettings& settings) noexcept;
    /// Defined beside the code that makes trainees, because a deleting destructor frees memory.
    ~SlopeCrossingsTechnique() override;
    void begin(const Percept& felt) noexcept override;
    SurfaceWish look(const Percept& felt) noexcept override;
    core::Vec2 estimate() const noexcept override { return m_apex; }

private:
    enum class Step { toStart, forth, back };
    void enter(Step step, const Percept& felt) noexcept;
    core::Vec2 goal() const noexcept;
    SurfaceWish finishAxis() noexcept;

    double m_firstHalfWidth_m;
    double m_speed_m_per_s;
    int m_crosses;
    ApexFit m_fit;
    Step m_step = Step::toStart;
    int m_axis = 0;
    int m_cross = 0;
    double m_halfWidth_m = 0.0;
    core::Vec2 m_apex = core::Vec2::Zero();
    core::Vec2 m_before = core::Vec2::Zero(); ///< apex as believed before this cross
    double m_entered_s = 0.0;
};

} // namespace chiron::operators
