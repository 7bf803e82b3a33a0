// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/hand_parameters.h"
#include "mechanisms/hand_strategy.h"
#include "operators/comparison/explored_place.h"
#include "operators/comparison/participant_mind.h"
#include "simulation/comparison/comparison_parameters.h"

#include <array>
#include <memory>

namespace chiron::operators {

/// The knowledge of a simulated participant: where the places are, which attribute matters, and, from the
/// practice, how strong such objects usually are, so that it can move by a sensible amount. It never includes
/// the value at a place.
struct ComparisonBriefing {
    simulation::ComparedAttribute attribute = simulation::ComparedAttribute::stiffness;
    int places = 3;
    std::array<double, 3> x_m{};
    double height_m = 0.030;               ///< of the rings
    double usualStiffness_N_per_m = 200.0; ///< of a usual tube or pad
    double padRadius_m = 0.009;            ///< of a pad's flat top, which it can see
    /// It was told to feel every object with at least this force; 0: it was told nothing.
    double probe_N = 0.0;
    double share = 0.0; ///< k₁/k: how much stiffer a quick press is than a slow one
};

ComparisonBriefing comparisonBriefing(const simulation::ComparisonParameters& parameters) noexcept;
/// The hand of a steady arm: firm, with little tremor and the usual reaction delay.
mechanisms::HandParameters comparisonHand() noexcept;

/// The hand of a simulated participant. In each trial it visits every place from left to right, makes the
/// exploratory movement that suits the attribute (Lederman & Klatzky 1987: pulls a tube, hefts an object,
/// presses and holds, strokes) and fits the attribute to what it feels (ExploredPlace). It sees its
/// instrument's tip, so the give of its own grip does not count as stretch of the object. Its movements
/// depend on time alone: minimum-jerk paths from point to point. After a trial in which a tube resisted too
/// much, it pulls all tubes less far.
/// Thread: haptic; allocates nothing.
class ComparisonExplorer final : public mechanisms::HandStrategy, public IParticipantMind {
public:
    ComparisonExplorer(const ComparisonBriefing& briefing, const mechanisms::HandParameters& hand) noexcept;
    ~ComparisonExplorer() override;

    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override;

    bool explored() const noexcept override { return m_explored; }
    double estimate(int place) const noexcept override;
    void again() noexcept override { begin(); }

private:
    struct Way {
        core::Vec3 to = core::Vec3::Zero();
        double time_s = 0.3;
    };
    static constexpr int kLastStep = 10;
    Way way(int place, int step) const noexcept;
    bool strokes() const noexcept;
    Way hookedWay(const core::Vec3& ring, int step) const noexcept;
    Way pressedWay(const core::Vec3& pad, int step) const noexcept;
    Way roughWay(const core::Vec3& pad, int step) const noexcept;
    core::Vec3 ring(int place) const noexcept;
    void begin() noexcept;
    void learnPull() noexcept;
    void nextWay() noexcept;
    void notice(const mechanisms::HandPerception& seen) noexcept;
    void feel(const mechanisms::HandPerception& seen) noexcept;
    bool feels(int place, const core::Vec3& tip, double& displacement_m) const noexcept;
    bool feelsRough(int place, double& displacement_m) const noexcept;

    ComparisonBriefing m_briefing;
    double m_grip_N_per_m;
    double m_arm_N_per_m;
    double m_reaction_s;
    std::array<ExploredPlace, 3> m_places;
    AirStroke m_air; ///< strokes without an object
    InstrumentFeel m_instrument;
    core::Vec3 m_at = core::Vec3::Zero(); ///< where the present movement began
    Way m_way;
    double m_way_s = 0.0; ///< time since it began
    core::Vec3 m_lastVelocity = core::Vec3::Zero();
    std::array<bool, 3> m_taken{}; ///< the object is held now
    std::array<bool, 3> m_takes{}; ///< the object has not been put down yet in this trial
    double m_pull = 1.0;           ///< share of the usual distance by which it pulls a tube
    double m_hardest_N = 0.0;      ///< largest force felt in this trial
    int m_place = 0;
    int m_step = 0;
    int m_trial = -1;
    bool m_moving = false;
    bool m_explored = false;
    bool m_calm = true; ///< no trial runs
};

/// Errors: badInput if there are no places or too many. Allocates.
core::Result<std::unique_ptr<ComparisonExplorer>> makeComparisonExplorer(const ComparisonBriefing& briefing);

} // namespace chiron::operators
