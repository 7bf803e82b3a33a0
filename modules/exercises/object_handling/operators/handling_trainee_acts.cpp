// SPDX-License-Identifier: GPL-3.0-or-later
// The single actions of the hand, one after the other.
#include "core/units.h"
#include "modules/exercises/object_handling/operators/handling_trainee.h"
#include "operators/laparoscopy/movement.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::Vec3;

namespace {
// Habits that all operators share: assumptions.
/// Height above an object's middle at which it moves over the object.
constexpr double kOver_m = 0.022;
constexpr double kBeside_m = 0.006;       ///< within this horizontal distance it lowers itself
constexpr double kClosing_s = 3.5;        ///< time without a hold before it tries again
constexpr double kLongestSqueeze_s = 4.0; ///< after this time it lifts what it holds
constexpr double kFirmEnough = 0.25;      ///< share of the wanted squeeze that may be missing when it lifts
constexpr double kHeft_Hz = 0.6;
/// Change of the felt force that shows that the bed carries the object.
constexpr double kCarried_N = 0.10;
/// Within this distance of where the object lay, the felt change may come from the bed.
constexpr double kNear_m = 0.003;
/// If it is lower than expected by more than this, it lets go anyway.
constexpr double kNoBed_m = 0.002;
constexpr double kLettingGo_s = 3.0;
/// The object is let go when the jaws are wider than it by this much.
constexpr double kFree_m = 0.003;
} // namespace

void HandlingTrainee::rest(GraspWish& wish) noexcept {
    wish.velocity_m_per_s =
        velocityTo(m_home, m_place, m_settings.moveGain_per_s, m_settings.reachSpeed_m_per_s);
    wish.jaw_rad = GraspReach::kWidest_rad;
    wish.jawSpeed_rad_per_s = m_settings.openSpeed_rad_per_s;
}

void HandlingTrainee::over(const GraspPercept& felt, GraspWish& wish) noexcept {
    const Vec3 lies = object(felt);
    const Vec3 goal = lies + Vec3(0.0, 0.0, kOver_m);
    const double radius = felt.screen().body[m_object].radius_m;
    const bool low = m_place.z() < lies.z() + 0.6 * kOver_m;
    const bool beside = (goal - m_place).head<2>().norm() > kBeside_m;
    wish.velocity_m_per_s = velocityTo(low && beside ? Vec3(m_place.x(), m_place.y(), goal.z()) : goal,
                                       m_place, m_settings.moveGain_per_s, m_settings.reachSpeed_m_per_s);
    wish.jaw_rad = openJaw(radius);
    wish.jawSpeed_rad_per_s = m_settings.jawSpeed_rad_per_s;
    const bool there =
        (goal - m_place).head<2>().norm() < m_settings.aim_m && std::abs(goal.z() - m_place.z()) < 0.004;
    m_thereSince_s = there ? (m_thereSince_s < 0.0 ? felt.time_s : m_thereSince_s) : -1.0;
    if (there && felt.time_s - m_thereSince_s >= m_settings.settle_s) {
        m_free_N = m_slowUp_N; // remembers how it feels to hold nothing
        begin(Doing::lower, felt.time_s);
    }
}

void HandlingTrainee::lower(const GraspPercept& felt, GraspWish& wish) noexcept {
    const Vec3 goal = object(felt);
    wish.velocity_m_per_s =
        velocityTo(goal, m_place, m_settings.moveGain_per_s, m_settings.lowerSpeed_m_per_s);
    wish.jaw_rad = openJaw(felt.screen().body[m_object].radius_m);
    if ((goal - m_place).head<2>().norm() > 2.0 * kBeside_m)
        return begin(Doing::over, felt.time_s);
    const bool there = (goal - m_place).norm() < m_settings.aim_m + 0.001;
    m_thereSince_s = there ? (m_thereSince_s < 0.0 ? felt.time_s : m_thereSince_s) : -1.0;
    if (there && felt.time_s - m_thereSince_s >= m_settings.settle_s) {
        m_from = goal;
        begin(Doing::close, felt.time_s);
    }
}

void HandlingTrainee::close(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept {
    wish.velocity_m_per_s.setZero();
    if (!holds(felt)) {
        wish.jaw_rad = 0.0;
        wish.jawSpeed_rad_per_s = m_settings.jawSpeed_rad_per_s;
        if (since(felt) > kClosing_s)
            begin(Doing::over, felt.time_s);
        return;
    }
    squeeze(felt, jaw_rad, wish);
    if (wrongSqueeze_N(felt) < kFirmEnough * wantedSqueeze_N(felt.screen()) ||
        since(felt) > kLongestSqueeze_s) {
        m_grip = m_place;
        begin(Doing::lift, felt.time_s);
    }
}

void HandlingTrainee::lift(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept {
    squeeze(felt, jaw_rad, wish);
    const Vec3 goal = m_grip + Vec3(0.0, 0.0, m_briefing.liftHeight_m + m_settings.clearance_m);
    wish.velocity_m_per_s =
        velocityTo(goal, m_place, m_settings.moveGain_per_s, m_settings.carrySpeed_m_per_s);
    if (goal.z() - m_place.z() > std::max(0.002, 0.4 * m_settings.clearance_m))
        return;
    if (m_deciding)
        return begin(Doing::weigh, felt.time_s);
    begin(Doing::carry, felt.time_s);
}

/// Moves the object up and down, so that friction in the instrument cancels, or holds it still.
void HandlingTrainee::weigh(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept {
    squeeze(felt, jaw_rad, wish);
    const double phase = 2.0 * core::kPi * kHeft_Hz * since(felt);
    wish.velocity_m_per_s = Vec3(0.0, 0.0, 2.0 * core::kPi * kHeft_Hz * m_settings.heft_m * std::cos(phase));
    if (since(felt) < m_settings.weighTime_s + 0.5)
        return;
    m_weights.weighed(m_object);
    const std::size_t here = m_object;
    choose();
    const bool stays = m_object == here && !m_deciding;
    if (!stays)
        m_object = here; // it goes back first; the choice is made again afterwards
    begin(Doing::carry, felt.time_s);
    m_deciding = m_deciding || !stays;
}

void HandlingTrainee::carry(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept {
    squeeze(felt, jaw_rad, wish);
    // As seen while held, so that an error of sight affects tip and object in the same way
    if (m_thereSince_s < 0.0 && since(felt) < m_settings.attention_s + Senses::kLook_s)
        m_hold = object(felt) - m_place;
    const Vec3 target = m_deciding || !felt.screen().targetShown ? m_from : vectorOf(felt.screen().p_WTarget);
    const Vec3 goal(target.x() - m_hold.x(), target.y() - m_hold.y(), m_place.z());
    const bool there = (goal - m_place).head<2>().norm() < m_settings.placeAim_m;
    wish.velocity_m_per_s =
        velocityTo(goal, m_place, there ? 0.0 : m_settings.moveGain_per_s, m_settings.carrySpeed_m_per_s);
    wish.velocity_m_per_s.z() = std::clamp(m_settings.moveGain_per_s * (m_grip.z() + m_briefing.liftHeight_m +
                                                                        m_settings.clearance_m - m_place.z()),
                                           -0.02, 0.02);
    m_thereSince_s = there ? (m_thereSince_s < 0.0 ? felt.time_s : m_thereSince_s) : -1.0;
    if (there && felt.time_s - m_thereSince_s >= m_settings.settle_s) {
        m_to = Vec3(goal.x(), goal.y(), m_grip.z());
        begin(Doing::setDown, felt.time_s);
    }
}

void HandlingTrainee::setDown(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept {
    squeeze(felt, jaw_rad, wish);
    const double low = m_to.z() + m_settings.releaseHeight_m;
    const double left = m_place.z() - low;
    const double fast = std::min(m_settings.carrySpeed_m_per_s,
                                 m_settings.moveGain_per_s * std::max(0.0, left - 2.0 * kNear_m));
    wish.velocity_m_per_s = Vec3(0.0, 0.0, -std::max(m_settings.setDownSpeed_m_per_s, fast));
    const bool near = left < kNear_m;
    const bool carried = m_settings.feelsTheBed ? near && m_up_N - m_slowUp_N > kCarried_N : left <= 0.0;
    if (!carried && left > -kNoBed_m)
        return;
    wish.velocity_m_per_s.setZero();
    begin(Doing::letGo, felt.time_s);
}

void HandlingTrainee::letGo(const GraspPercept& felt, GraspWish& wish) noexcept {
    wish.velocity_m_per_s.setZero();
    wish.jaw_rad = openJaw(felt.screen().body[m_object].radius_m + kFree_m);
    wish.jawSpeed_rad_per_s = m_settings.openSpeed_rad_per_s;
    if (!holds(felt) || since(felt) > kLettingGo_s)
        begin(Doing::leave, felt.time_s);
}

void HandlingTrainee::leave(const GraspPercept& felt, GraspWish& wish) noexcept {
    const Vec3 goal = object(felt) + Vec3(0.0, 0.0, kOver_m + 0.008);
    wish.velocity_m_per_s = velocityTo(Vec3(m_place.x(), m_place.y(), goal.z()), m_place,
                                       m_settings.moveGain_per_s, 0.5 * m_settings.reachSpeed_m_per_s);
    wish.jaw_rad = openJaw(felt.screen().body[m_object].radius_m + kFree_m);
    wish.jawSpeed_rad_per_s = m_settings.openSpeed_rad_per_s;
    if (m_place.z() < goal.z() - 0.004)
        return;
    if (m_deciding) {
        choose();
        return begin(Doing::over, felt.time_s);
    }
    // If the object was set down beside its target, it is picked up again, provided that the screen still
    // asks for it.
    const Vec3 lies = object(felt);
    const bool missed =
        felt.screen().targetShown &&
        (lies - vectorOf(felt.screen().p_WTarget)).head<2>().norm() > felt.screen().targetRadius_m;
    if (missed && since(felt) > 1.0)
        begin(Doing::over, felt.time_s);
}

} // namespace chiron::operators
