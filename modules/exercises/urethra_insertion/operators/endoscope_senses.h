// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "mechanisms/hand_strategy.h"
#include "mechanisms/markov_noise.h"
#include "modules/exercises/urethra_insertion/operators/endoscope_perception_settings.h"

#include <array>

namespace chiron::operators {

/// Something in the picture: its angles off the centre of the view (up and to the left, which equal the turns
/// in pitch and yaw that bring it there), and its distance ahead.
struct SeenThing {
    bool seen = false;
    double up_rad = 0.0;
    double left_rad = 0.0;
    double distance_m = 0.0;
};

/// The sensations and sights that an endoscopist believes to have; its strategy may use nothing else. Forces
/// and torques are as the hand feels them: along the instrument, and across it in the plane in which the tip
/// moves.
struct EndoscopePercept {
    double time_s = 0.0;
    double pitch_rad = 0.0; ///< felt pitch of the instrument above the table
    double yaw_rad = 0.0;
    double along_N = 0.0;        ///< on the hand; positive pushes the instrument in
    double across_N = 0.0;       ///< positive upwards (of the instrument)
    double pitchTorque_Nm = 0.0; ///< on the hand
    double yawTorque_Nm = 0.0;
    double depth_m = 0.0;
    SeenThing lumen;
    SeenThing landmark;
    core::VisibleCues cues; ///< as shown; directions and depth must be read from the members above instead
};

/// Converts the true state of a hand and of the screen into sensations: 100 observations per second, each
/// from the mean of ten ticks, with the noises of EndoscopePerceptionSettings. Seeded.
/// Thread: haptic; allocates nothing.
class EndoscopeSenses {
public:
    static constexpr int kTicksPerLook = 10;
    static constexpr double kLook_s = 0.01;

    EndoscopeSenses(const EndoscopePerceptionSettings& settings, std::uint64_t seed) noexcept;
    /// Call in every tick. Returns true when percept() holds a new observation.
    bool feel(const mechanisms::HandPerception& real) noexcept;
    const EndoscopePercept& percept() const noexcept { return m_percept; }

private:
    void look(const mechanisms::HandPerception& real) noexcept;
    void feelForces(double pitch_rad, double yaw_rad) noexcept;
    SeenThing see(const core::Vec3& to_T, double distance_m, double unmarked) noexcept;

    EndoscopePerceptionSettings m_settings;
    core::Random m_random;
    std::array<mechanisms::MarkovNoise, 2> m_angleBias, m_angleQuick, m_picture, m_floor, m_torqueFloor;
    mechanisms::MarkovNoise m_distance, m_depth, m_weber, m_torqueWeber, m_direction, m_directionBias;
    core::Vec3 m_sumForce = core::Vec3::Zero();
    core::Vec3 m_sumTorque = core::Vec3::Zero();
    int m_ticks = 0;
    EndoscopePercept m_percept;
};

} // namespace chiron::operators
