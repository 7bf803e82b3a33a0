// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "cues/laparoscopy_cues.h"
#include "mechanisms/markov_noise.h"
#include "modules/exercises/elastic_tube/operators/elastic_tube_operator.h"
#include "modules/exercises/elastic_tube/operators/tension_control.h"
#include "operators/laparoscopy/laparoscopy_mind.h"

#include <array>
#include <cstdint>

namespace chiron::operators {

/// The strategy of one scripted laparoscopist at the elastic tube, with one to three hands. It rests until a
/// trial runs and force is fully on. Then each hand goes to its own place of the tube and closes its jaw
/// there. Once the tube is held, the hands draw its ends apart according to the tension that they read or
/// feel, or lead the end to its target and hand it over. It knows only what it was told
/// (ElasticTubeBriefing), what its hands feel and what the screen shows, through GraspSenses.
/// Thread: haptic; allocates nothing.
class TubeTrainee final : public LaparoscopyMind {
public:
    TubeTrainee(const ElasticTubeOperatorSettings& settings, const ElasticTubeBriefing& briefing,
                std::uint64_t seed);
    ~TubeTrainee() override;
    void think(const GraspLook& felt, GraspWishes& wishes) noexcept override;

private:
    static constexpr int kNone = -1;
    enum class Doing { wait, reach, close, hold, letGo };
    struct Hand {
        Doing doing = Doing::wait;
        double began_s = 0.0;
        int grip = kNone;                      ///< place of the tube that is this hand's in this trial
        core::Vec3 place = core::Vec3::Zero(); ///< smoothed
        core::Vec3 force = core::Vec3::Zero(); ///< smoothed
        core::Vec3 rest = core::Vec3::Zero();  ///< where it waits
        mechanisms::MarkovNoise jaw;
    };

    void notice(const GraspLook& felt) noexcept;
    void share(const core::LaparoscopyCues& screen) noexcept; ///< decides which hand takes which place
    int gripOf(std::size_t hand, const core::LaparoscopyCues& screen) const noexcept;
    bool holds(std::size_t hand, const core::LaparoscopyCues& screen) const noexcept;
    bool allHold(const core::LaparoscopyCues& screen) const noexcept;
    void rest(const GraspLook& felt, GraspWishes& wishes) noexcept;
    void decide(std::size_t hand, const GraspLook& felt, GraspWish& wish) noexcept;
    void begin(Hand& hand, Doing doing, double now_s) noexcept;
    void seek(std::size_t hand, const GraspPercept& felt, const core::Vec3& grip, GraspWish& wish) noexcept;
    void retract(const GraspPercept& felt, GraspWish& wish) noexcept;
    void mindFold(const GraspPercept& felt) noexcept;
    TensionView foldView(const GraspPercept& felt) const noexcept;
    void work(std::size_t hand, const GraspPercept& felt, GraspWish& wish) noexcept;
    core::Vec3 pull(std::size_t hand, const core::LaparoscopyCues& screen) const noexcept;
    core::Vec3 bring(std::size_t hand, const core::LaparoscopyCues& screen) const noexcept;
    core::Vec3 otherEnd(std::size_t hand, const core::LaparoscopyCues& screen) const noexcept;
    TensionView view(const GraspLook& felt) const noexcept;
    double heldJaw(Hand& hand) noexcept;

    ElasticTubeOperatorSettings m_settings;
    ElasticTubeBriefing m_briefing;
    core::Random m_random;
    TensionControl m_tension;
    TensionControl m_retraction; ///< for hand m_count, which holds a fold back
    std::array<Hand, GraspLook::kHands> m_hands;
    std::size_t m_all = 1;   ///< number of hands
    std::size_t m_count = 1; ///< number of hands that work on the tube
    bool m_retracting = false;
    bool m_awake = false;
    bool m_working = false;
    bool m_pulling = false;
    double m_speed_m_per_s = 0.0; ///< with which the ends are drawn apart
    double m_decided_s = -1.0;
};

} // namespace chiron::operators
