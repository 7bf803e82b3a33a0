// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/palpation/operators/finger_senses.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::Vec3;

namespace {
constexpr double kLeastDepth_m = 0.0005; ///< with less depth no stiffness can be judged: assumption
}

FingerSenses::FingerSenses(const PalpationPerceptionSettings& settings,
                           const mechanisms::HandParameters& hand, const devices::WorkspaceMapping& place,
                           std::uint64_t seed, const simulation::SurfaceShape& drawn)
    : m_settings(settings), m_map(place), m_surface(drawn),
      m_random(core::Random::stream(seed, "palpation/senses")), m_instrument(hand) {}

/// Lean as in models.md §3: roll is about y and tilts along x, pitch is about x and tilts against y (P3's
/// platform).
FingerSenses::Touch FingerSenses::padTouch(const mechanisms::HandPerception& real,
                                           const Vec3& normal_W) const noexcept {
    const Vec3 across = m_map.orientationToW(real.q_DT) * Vec3::UnitX();
    const Vec3 x = (across - across.dot(normal_W) * normal_W).normalized();
    const core::DisplayPose pad = m_map.displayToW(real.pad);
    Touch out;
    out.force_N = pad.normalForce_N;
    out.lean_rad = pad.roll_rad * x - pad.pitch_rad * normal_W.cross(x);
    return out;
}

FingerSenses::Touch FingerSenses::heldTouch(const Vec3& force_W, const Vec3& normal_W) const noexcept {
    Touch out;
    out.force_N = force_W.dot(normal_W);
    const Vec3 lateral = force_W - out.force_N * normal_W;
    const double size = lateral.norm();
    if (size > 1e-9 && out.force_N > m_settings.touch_N)
        out.lean_rad = std::atan2(size, out.force_N) / size * lateral;
    return out;
}

/// Over an organ, the height refers to the nearest point of the drawn surface and not to the plane at the
/// intended spot. The hand still swings sideways when it touches, and on a bend of 11 mm the plane is a
/// millimetre off where the finger is 5 mm beside the spot.
FingerSenses::Seen FingerSenses::seenAt(const Vec3& place_W, const FingerOrder& order) const noexcept {
    if (m_surface.flat()) {
        const double height = (place_W - order.surface_W).dot(order.normal_W);
        return {height, place_W - height * order.normal_W};
    }
    const simulation::SurfaceFoot foot = m_surface.nearest(place_W, place_W.head<2>());
    return {-foot.depth_m, foot.p_W};
}

bool FingerSenses::feel(const mechanisms::HandPerception& real, const FingerOrder& order) noexcept {
    if (!real.fingertip)
        m_instrument.feel(real.p_DT, real.f_T_D);
    const Seen seen = seenAt(m_map.pointToW(real.fingertip ? real.p_DT : m_instrument.tip()), order);
    const Touch touch = real.fingertip
                            ? padTouch(real, order.normal_W)
                            : heldTouch(m_map.wrenchToW({real.f_T_D, Vec3::Zero()}).force, order.normal_W);
    if (!m_touching && touch.force_N >= m_settings.touch_N && (real.fingertip || seen.height_m <= 0.0)) {
        m_touching = true;
        m_touchedAt_m = real.fingertip ? seen.height_m : 0.0;
    } else if (m_touching && touch.force_N < 0.5 * m_settings.touch_N) {
        m_touching = false;
    }
    if (order.press == m_attended)
        return false;
    if (real.time_s >= order.attendFrom_s && real.time_s < order.attendUntil_s) {
        m_force_N += touch.force_N;
        m_lean_rad += touch.lean_rad;
        m_depth_m += (m_touching ? m_touchedAt_m : 0.0) - seen.height_m;
        m_place_W += seen.foot_W;
        ++m_ticks;
        m_touchedTicks += m_touching ? 1 : 0;
    }
    if (real.time_s < order.attendUntil_s)
        return false;
    m_attended = order.press;
    if (m_ticks == 0)
        return false;
    judge(real.fingertip, order.pressure);
    return true;
}

void FingerSenses::judge(bool platform, int pressure) noexcept {
    const double n = m_ticks;
    const PerceptionSettings& hand = m_settings.hand;
    const double looks = std::max(1.0, n * core::kTickSeconds / hand.forceNoiseTime_s);
    const double share = 1.0 / std::sqrt(looks);
    const auto noise = [&](double sd) { return sd * m_random.normal(); };
    m_press.pressure = pressure;
    m_press.touched = 2 * m_touchedTicks > m_ticks;
    m_press.force_N =
        m_force_N / n * (1.0 + noise(share * hand.forceWeberFraction)) + noise(share * hand.forceFloorSd_N);
    m_press.depth_m = m_depth_m / n * (1.0 + noise(m_settings.depthWeberFraction));
    m_press.stiffness_N_per_m =
        m_press.force_N / std::max(m_press.depth_m, kLeastDepth_m) * (1.0 + noise(m_settings.memoryFraction));
    const double leanSd = share * (platform ? m_settings.leanNoiseSd_rad : hand.directionNoiseSd_rad);
    for (int axis = 0; axis < 2; ++axis) {
        m_press.lean_rad[axis] = m_lean_rad[axis] / n + noise(leanSd);
        m_press.place_m[axis] = m_place_W[axis] / n + noise(hand.visionNoiseSd_m);
    }
    m_ticks = m_touchedTicks = 0;
    m_force_N = m_depth_m = 0.0;
    m_lean_rad.setZero();
    m_place_W.setZero();
}

} // namespace chiron::operators
