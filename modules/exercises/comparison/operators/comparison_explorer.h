// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/hand_parameters.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/comparison/operators/explored_place.h"
#include "modules/exercises/comparison/operators/participant_mind.h"
#include "modules/exercises/comparison/simulation/comparison_parameters.h"

#include <array>
#include <memory>

namespace chiron::operators {

/// What a participant knows: where the places are and what to attend to; and how strong an object of the kind is on the whole, from
/// the practice, to move by a sensible amount. Never what lies at a place.
struct ComparisonBriefing {
    simulation::ComparedAttribute attribute = simulation::ComparedAttribute::stiffness;
    int places = 3;
    std::array<double, 3> x_m{};
    double height_m = 0.030;       ///< of the rings
    double usualStiffness_N_per_m = 200.0; ///< of a tube or pad
    double padRadius_m = 0.009;    ///< of a pad's flat top: it sees it
    double probe_N = 0.0;          ///< it was told to feel every object with so much at least; 0: nothing
    double share = 0.0;            ///< how much stiffer a quick press is: k₁/k
};

ComparisonBriefing comparisonBriefing(const simulation::ComparisonParameters& parameters) noexcept;
/// A steady arm: firm, with little tremor and the usual reaction delay.
mechanisms::HandParameters comparisonHand() noexcept;

/// A simulated participant's hand: in each trial it goes to every place from left to right, does there what the attribute asks for
/// (Lederman & Klatzky 1987: pulls a tube, hefts an object, presses and holds, strokes) and fits the attribute to what it feels
/// (ExploredPlace). It sees its instrument's tip, so what its own grip gives is no stretch of the object. It moves by time alone:
/// min-jerk ways from point to point; after a trial in which a tube resisted too much it pulls all tubes less far. Haptic thread; no allocation.
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
    core::Vec3 m_at = core::Vec3::Zero(); ///< where the present way began
    Way m_way;
    double m_way_s = 0.0;   ///< along it
    core::Vec3 m_lastVelocity = core::Vec3::Zero();
    std::array<bool, 3> m_taken{}; ///< held now
    std::array<bool, 3> m_takes{}; ///< and not yet put down, in this trial
    double m_pull = 1.0;      ///< share of the usual way that it pulls a tube
    double m_hardest_N = 0.0; ///< felt in this trial
    int m_place = 0;
    int m_step = 0;
    int m_trial = -1;
    bool m_moving = false;
    bool m_explored = false;
    bool m_calm = true; ///< no trial runs
};

/// Failure: badInput (no or too many places). Allocates.
core::Result<std::unique_ptr<ComparisonExplorer>> makeComparisonExplorer(const ComparisonBriefing& briefing);

} // namespace chiron::operators
