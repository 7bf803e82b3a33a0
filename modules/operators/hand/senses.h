// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "mechanisms/hand_strategy.h"
#include "mechanisms/markov_noise.h"
#include "operators/hand/perception_settings.h"

#include <array>

namespace chiron::operators {

/// What a scripted operator believes it feels and sees; its strategy may use nothing else.
/// Frame: D.
struct Percept {
    double time_s = 0.0;
    core::Vec3 place = core::Vec3::Zero(); ///< of its hand, m
    core::Vec3 force = core::Vec3::Zero(); ///< on its hand, N
    /// Felt lateral share of the force, (f_x, f_y)/‖f‖: the sine of the touched surface's inclination,
    /// pointing away from the hill; zero if nothing firm is felt.
    core::Vec2 slope = core::Vec2::Zero();
    bool touching = false; ///< something firm is felt
    bool objectSeen = false;
    core::Vec2 seenApex = core::Vec2::Zero(); ///< seen position of the object's middle; only with objectSeen
    core::VisibleCues cues;                   ///< as shown; of its object only seenApex may be used
};

/// Converts what really happens to a hand into what it feels: 100 percepts ("looks") per second, each from
/// the mean of ten ticks, with the noises of PerceptionSettings. Seeded.
/// Thread: haptic; allocates nothing.
class Senses {
public:
    static constexpr int kTicksPerLook = 10;
    static constexpr double kLook_s = 0.01;
    /// Felt force, smoothed over 0.1 s, that counts as touch: friction of the drives, inertia and tremor stay
    /// below it. Assumption.
    static constexpr double kTouch_N = 0.35;

    Senses(const PerceptionSettings& settings, std::uint64_t seed) noexcept;
    /// Call it every tick. Returns true when a new percept is ready in percept().
    bool feel(const mechanisms::HandPerception& real) noexcept;
    const Percept& percept() const noexcept { return m_percept; }

private:
    void look(const mechanisms::HandPerception& real) noexcept;
    core::Vec3 feltForce(const core::Vec3& real) noexcept;

    PerceptionSettings m_settings;
    core::Random m_random;
    std::array<mechanisms::MarkovNoise, 3> m_bias;
    std::array<mechanisms::MarkovNoise, 3> m_quick;
    std::array<mechanisms::MarkovNoise, 3> m_vision;
    std::array<mechanisms::MarkovNoise, 3> m_floor;
    mechanisms::MarkovNoise m_weber;
    std::array<mechanisms::MarkovNoise, 2> m_direction;
    std::array<mechanisms::MarkovNoise, 2> m_directionBias;
    core::Vec3 m_sumForce = core::Vec3::Zero();
    core::Vec3 m_sumPlace = core::Vec3::Zero();
    int m_ticks = 0;
    core::Vec3 m_smooth = core::Vec3::Zero();
    Percept m_percept;
};

} // namespace chiron::operators
