// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "cues/laparoscopy_cues.h"
#include "devices/api/workspace_map.h"
#include "mechanisms/hand_strategy.h"
#include "mechanisms/markov_noise.h"
#include "operators/hand/senses.h"
#include "operators/laparoscopy/grasp_perception_settings.h"

#include <cstdint>

namespace chiron::operators {

/// What a laparoscopist believes one hand feels and the screen shows; its strategy may use nothing else.
/// Frame: W.
struct GraspPercept {
    double time_s = 0.0;
    /// Position of the instrument's tip: as seen, or as felt if the screen shows nothing, m.
    core::Vec3 place = core::Vec3::Zero();
    core::Vec3 force = core::Vec3::Zero(); ///< on the hand, N
    double tension_N = 0.0;                ///< as read from its bar; 0 if the bar is not shown
    double retraction_N = 0.0;             ///< of a fold that is held back, likewise
    double squeeze_N = 0.0;                ///< of this hand's jaw, likewise
    double stretch_m = 0.0;                ///< of the tube, as seen
    double flattening_m = 0.0;             ///< of the object between this hand's jaws, as seen
    core::VisibleCues cues;                ///< as shown; the values above must not be read from here

    bool working() const noexcept {
        return cues.phase == core::TrialPhase::running && cues.force == core::ForceState::on;
    }
    const core::LaparoscopyCues& screen() const noexcept { return cues.exercise.of<core::LaparoscopyCues>(); }
};

/// Converts what really happens to one hand and on the screen into what is felt and seen: 100 percepts per
/// second from the mean of ten ticks (Senses), with the noises of GraspPerceptionSettings. Seeded.
/// Thread: haptic; allocates nothing.
class GraspSenses {
public:
    GraspSenses(const GraspPerceptionSettings& settings, std::size_t hand,
                const devices::WorkspaceMapping& place, std::uint64_t seed) noexcept;
    /// Call it every tick. Returns true when a new percept is ready in percept().
    bool feel(const mechanisms::HandPerception& real) noexcept;
    const GraspPercept& percept() const noexcept { return m_percept; }

private:
    double seenFlattening(const core::LaparoscopyCues& screen) noexcept;
    double readBar(double shown_N, mechanisms::MarkovNoise& weber, mechanisms::MarkovNoise& floor) noexcept;

    GraspPerceptionSettings m_settings;
    std::size_t m_hand;
    devices::WorkspaceMap m_map;
    core::Random m_random;
    Senses m_senses;
    mechanisms::MarkovNoise m_tensionWeber, m_tensionFloor, m_squeezeWeber, m_squeezeFloor, m_length,
        m_thickness;
    GraspPercept m_percept;
};

} // namespace chiron::operators
