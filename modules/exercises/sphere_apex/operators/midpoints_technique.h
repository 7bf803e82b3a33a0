// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/sphere_apex/operators/apex_technique.h"
#include "modules/exercises/sphere_apex/operators/sphere_apex_operator_settings.h"

namespace chiron::operators {

/// Sweeps along x until the surface feels steep, sweeps back until it feels steep on the other side (or the
/// surface ends), and takes the middle. Then it does the same along y through that middle.
class MidpointsTechnique final : public ApexTechnique {
public:
    explicit MidpointsTechnique(const SphereApexOperatorSettings& settings) noexcept;
    /// Defined beside the code that makes trainees, because a deleting destructor frees memory.
    ~MidpointsTechnique() override;
    void begin(const Percept& felt) noexcept override;
    SurfaceWish look(const Percept& felt) noexcept override;
    core::Vec2 estimate() const noexcept override { return m_middle; }

private:
    enum class Step { up, down, centre };
    void startSweep(Step step, const Percept& felt) noexcept;

    double m_edgeSlope;
    double m_speed_m_per_s;
    Step m_step = Step::up;
    int m_axis = 0;
    int m_edges = 0; ///< sweeps that ended on a steep surface; if at most one of four did, this is the table
    core::Vec2 m_middle = core::Vec2::Zero();
    core::Vec2 m_slope = core::Vec2::Zero();   ///< felt, smoothed over about one observation
    core::Vec2 m_touched = core::Vec2::Zero(); ///< where it touched last
    core::Vec2 m_line = core::Vec2::Zero();    ///< keeps the other coordinate constant
    double m_edge = 0.0;
    double m_touchedFor_s = 0.0; ///< in this sweep
    double m_turned_s = 0.0;
};

} // namespace chiron::operators
