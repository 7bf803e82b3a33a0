// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/elastic_tube/operators/elastic_tube_operator_settings.h"

namespace chiron::operators {

/// Estimates how much tension a pull adds: the slope of tension over length, by least squares with
/// forgetting.
class StiffnessSense {
public:
    explicit StiffnessSense(double assumed_N_per_m) noexcept
        : m_slope(assumed_N_per_m), m_assumed(assumed_N_per_m) {}
    void begin() noexcept;
    void notice(double length_m, double tension_N) noexcept; ///< once per observation
    double stiffness_N_per_m() const noexcept { return m_slope; }

private:
    double m_slope;
    double m_assumed;
    double m_weight = 0.0, m_length = 0.0, m_tension = 0.0, m_spread = 0.0, m_both = 0.0;
};

/// Inputs of the tension control: the wanted tension and the present pull, as far as the trainee knows them.
struct TensionView {
    double tension_N = 0.0; ///< as read or felt
    double length_m = 0.0;  ///< between the ends, as seen
    double restLength_m = 0.0;
    double low_N = 0.0, high_N = 0.0; ///< the band; 0: not shown
    double dwell = 0.0;               ///< 0..1: share of the holding time that has passed
    double time_s = 0.0;
};

/// Keeps a tension by controlling the speed with which the ends are drawn apart. Where no band is shown, it
/// pulls slowly until the screen begins to count, remembers how that felt, and keeps that tension. Called
/// once per observation; allocates nothing.
class TensionControl {
public:
    explicit TensionControl(const ElasticTubeOperatorSettings& settings) noexcept
        : m_settings(settings), m_stiffness(settings.assumedStiffness_N_per_m) {}
    void begin() noexcept; ///< call it when the hand has taken hold of the tube
    void look(const TensionView& view) noexcept;
    double speed_m_per_s(const TensionView& view) noexcept; ///< positive: apart

private:
    double search(const TensionView& view) noexcept;
    double correct(double wrong_N, double halfBand_N) const noexcept;

    ElasticTubeOperatorSettings m_settings;
    StiffnessSense m_stiffness;
    double m_dwell = 0.0;
    double m_counted_s = -1.0;   ///< when the screen last counted the tension as right
    double m_remembered_N = 0.0; ///< tension felt at that time; 0: none yet
    double m_lost_s = -1.0;      ///< since when the screen has not counted any more
};

} // namespace chiron::operators
