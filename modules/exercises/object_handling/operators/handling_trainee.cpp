// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/object_handling/operators/handling_trainee.h"

#include "operators/laparoscopy/movement.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::LaparoscopyCues;
using core::Vec3;

namespace {
// Habits that all operators share: assumptions.
constexpr double kSmoothing = 0.1;      ///< share per observation for smoothing position and force: 0.1 s
constexpr double kSlowSmoothing = 0.01; ///< 1 s
constexpr double kJawRoom_m = 0.004;    ///< room between each open jaw and the object
/// Squeeze that it infers when an object looks flattened by its whole radius.
constexpr double kFlat_N = 2.0;
constexpr double kFirmest = 1.9; ///< greatest factor over the squeeze that it wanted at first
} // namespace

void HandlingTrainee::think(const GraspLook& felt, GraspWishes& wishes) noexcept {
    const GraspPercept& now = felt.first();
    notice(now);
    const LaparoscopyCues& screen = now.screen();
    const bool working = now.working() && screen.present && screen.objectShown && screen.bodies > 0;
    if (!working) {
        if (m_doing != Doing::rest)
            begin(Doing::rest, now.time_s);
        return rest(wishes[0]);
    }
    if (m_doing == Doing::rest)
        beginTrial(now);
    if (now.time_s < m_decided_s + m_settings.attention_s)
        return;
    m_decided_s = now.time_s;
    act(now, felt.jaw_rad[0], wishes[0]);
}

void HandlingTrainee::notice(const GraspPercept& felt) noexcept {
    if (!m_awake) {
        m_awake = true;
        m_home = m_place = felt.place;
    }
    smoothTowards(m_place, felt.place, kSmoothing);
    smoothTowards(m_up_N, felt.force.z(), kSmoothing);
    smoothTowards(m_slowUp_N, felt.force.z(), kSlowSmoothing);
    if (m_doing == Doing::weigh && since(felt) > 0.5 && holds(felt))
        m_weights.feel(m_object, m_free_N - felt.force.z());
}

void HandlingTrainee::beginTrial(const GraspPercept& felt) noexcept {
    m_weights.begin(static_cast<std::size_t>(felt.screen().bodies));
    m_deciding = m_briefing.weigh && felt.screen().bodies > 1;
    m_rounds = 1;
    m_object = 0;
    m_firmness = 1.0;
    m_decided_s = -1.0;
    choose();
    begin(Doing::over, felt.time_s);
}

void HandlingTrainee::begin(Doing doing, double now_s) noexcept {
    m_doing = doing;
    m_began_s = now_s;
    m_thereSince_s = -1.0;
}

/// Weighs each object in turn, then the two heaviest once more if they are close. Then it chooses the one
/// that felt heaviest.
void HandlingTrainee::choose() noexcept {
    if (!m_deciding)
        return;
    const std::size_t next = m_weights.next(1);
    if (next < m_weights.objects()) {
        m_object = next;
        return;
    }
    if (m_rounds == 1 && m_weights.close(m_settings.weighAgain))
        m_rounds = 2;
    if (m_rounds == 2) {
        for (const std::size_t candidate : {m_weights.heaviest(), m_weights.second()})
            if (candidate < m_weights.objects() && m_weights.times(candidate) < 2) {
                m_object = candidate;
                return;
            }
    }
    m_deciding = false;
    m_object = m_weights.heaviest();
}

void HandlingTrainee::act(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept {
    const bool carrying = m_doing == Doing::lift || m_doing == Doing::weigh || m_doing == Doing::carry ||
                          m_doing == Doing::setDown;
    if (carrying && lostIt(felt))
        begin(Doing::over, felt.time_s);
    switch (m_doing) {
    case Doing::rest:
        return rest(wish);
    case Doing::over:
        return over(felt, wish);
    case Doing::lower:
        return lower(felt, wish);
    case Doing::close:
        return close(felt, jaw_rad, wish);
    case Doing::lift:
        return lift(felt, jaw_rad, wish);
    case Doing::weigh:
        return weigh(felt, jaw_rad, wish);
    case Doing::carry:
        return carry(felt, jaw_rad, wish);
    case Doing::setDown:
        return setDown(felt, jaw_rad, wish);
    case Doing::letGo:
        return letGo(felt, wish);
    case Doing::leave:
        return leave(felt, wish);
    }
}

bool HandlingTrainee::holds(const GraspPercept& felt) const noexcept {
    return (felt.screen().body[m_object].heldBy & 1U) != 0;
}

/// Returns true if the object slipped out; the next grip is then firmer.
bool HandlingTrainee::lostIt(const GraspPercept& felt) noexcept {
    if (holds(felt))
        return false;
    m_firmness = std::min(kFirmest, m_firmness * m_settings.regripFactor);
    return true;
}

core::Vec3 HandlingTrainee::object(const GraspPercept& felt) const noexcept {
    return vectorOf(felt.screen().body[m_object].p_W);
}

double HandlingTrainee::openJaw(double radius_m) const noexcept {
    return 2.0 * std::asin(std::clamp((radius_m + kJawRoom_m) / m_briefing.jawLength_m, 0.0, 0.7));
}

double HandlingTrainee::wantedSqueeze_N(const LaparoscopyCues& screen) const noexcept {
    const bool bar = screen.squeezeShown && screen.squeezeLimit_N > 0.0;
    return m_firmness *
           (bar ? m_settings.squeezeShare * screen.squeezeLimit_N : kFlat_N * m_settings.flatteningShare);
}

/// The missing squeeze, in newtons as far as the eye can tell; positive: squeeze more. Without a bar it is
/// judged by how flat the object looks.
double HandlingTrainee::wrongSqueeze_N(const GraspPercept& felt) const noexcept {
    const LaparoscopyCues& screen = felt.screen();
    if (screen.squeezeShown && screen.squeezeLimit_N > 0.0)
        return wantedSqueeze_N(screen) - felt.squeeze_N;
    const double share = felt.flattening_m / std::max(screen.body[m_object].radius_m, 1e-4);
    return wantedSqueeze_N(screen) - kFlat_N * share;
}

/// Keeps the squeeze at the wanted value.
void HandlingTrainee::squeeze(const GraspPercept& felt, double jaw_rad, GraspWish& wish) const noexcept {
    const double wrong = wrongSqueeze_N(felt);
    const bool right = std::abs(wrong) < m_settings.squeezeTolerance * wantedSqueeze_N(felt.screen());
    wish.jawSpeed_rad_per_s = right ? 0.0
                                    : std::min(m_settings.squeezeGain_rad_per_Ns * std::abs(wrong),
                                               m_settings.squeezeSpeed_rad_per_s);
    wish.jaw_rad = wrong > 0.0 ? 0.0 : std::min(jaw_rad + 0.2, GraspReach::kWidest_rad);
}

} // namespace chiron::operators
