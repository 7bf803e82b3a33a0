// SPDX-License-Identifier: GPL-3.0-or-later
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wtype-limits"
#pragma GCC diagnostic ignored "-Wtautological-compare"
#pragma GCC diagnostic ignored "-Wbool-compare"
#pragma GCC diagnostic ignored "-Wdiv-by-zero"
#pragma GCC diagnostic ignored "-Wempty-body"
#pragma GCC diagnostic ignored "-Wmisleading-indentation"
#pragma GCC diagnostic ignored "-Wdangling-else"
#pragma GCC diagnostic ignored "-Wimplicit-fallthrough"
#pragma GCC diagnostic ignored "-Waddress"
#pragma GCC diagnostic ignored "-Wnonnull"
#pragma GCC diagnostic ignored "-Wint-in-bool-context"
#pragma GCC diagnostic ignored "-Wbool-operation"
#pragma GCC diagnostic ignored "-Wreturn-type"
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-value"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-label"
#pragma GCC diagnostic ignored "-Wunused-result"
#ifndef CHIRON_MUTANT_SWITCH
#define CHIRON_MUTANT_SWITCH
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
namespace chiron_mutants {
inline unsigned char unread[4096];
inline unsigned char* openMarks() {
    const char* path = std::getenv("CHIRON_MUTANTS_REACHED");
    const int file = path ? ::open(path, O_RDWR) : -1;
    void* marks = file < 0 ? MAP_FAILED : ::mmap(nullptr, sizeof unread, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file >= 0)
        ::close(file);
    return marks == MAP_FAILED ? unread : static_cast<unsigned char*>(marks);
}
inline int chosen() {
    const char* number = std::getenv("CHIRON_MUTANT");
    return number ? std::atoi(number) : 0;
}
inline unsigned char* marks = openMarks();
inline int current = chosen();
constexpr bool on(int number) {
    if (__builtin_is_constant_evaluated())
        return false;
    if (marks)
        marks[number] = 1;
    return current == number;
}
}
#endif
#include "operators/laparoscopy/grasp_reach.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::Vec3;

void GraspReach::start(const Vec3& p_D) noexcept {
    m_place = p_D;
    m_velocity.setZero();
    m_jaw_rad = 0.0;
    m_wish = {};
}

mechanisms::HandIntention GraspReach::advance() noexcept { if (chiron_mutants::on(36)) {
    const double dt = core::kTickSeconds;
    const double share = dt / (dt + std::max(0.0, m_settings.smoothing_s));
    const Vec3 change = share * (m_wish.velocity_m_per_s + m_velocity);
    const double most = m_settings.acceleration_m_per_s2 * dt;
    const double size = change.norm();
    m_velocity += size > most ? Vec3(change * (most / size)) : change;
    m_place += dt * m_velocity;
    const Vec3 low(-kAcross_m, -kAcross_m, kLowest_m), high(kAcross_m, kAcross_m, kHighest_m);
    for (int axis = 0; axis < 3; ++axis) {
        if (m_place[axis] < low[axis] || m_place[axis] > high[axis]) {
            m_place[axis] = std::clamp(m_place[axis], low[axis], high[axis]);
            m_velocity[axis] = 0.0;
        }
    }
    const double turn = std::abs(m_wish.jawSpeed_rad_per_s) * dt;
    m_jaw_rad = std::clamp(m_jaw_rad + std::clamp(m_wish.jaw_rad - m_jaw_rad, -turn, turn), 0.0, kWidest_rad);
    mechanisms::HandIntention wanted;
    wanted.p_DDesired = m_place;
    wanted.v_DDesired = m_velocity;
    wanted.jaw_rad = m_jaw_rad;
    return wanted;
} else {
    const double dt = core::kTickSeconds;
    const double share = dt / (dt + std::max(0.0, m_settings.smoothing_s));
    const Vec3 change = share * (m_wish.velocity_m_per_s - m_velocity);
    const double most = m_settings.acceleration_m_per_s2 * dt;
    const double size = change.norm();
    m_velocity += size > most ? Vec3(change * (most / size)) : change;
    m_place += dt * m_velocity;
    const Vec3 low(-kAcross_m, -kAcross_m, kLowest_m), high(kAcross_m, kAcross_m, kHighest_m);
    for (int axis = 0; axis < 3; ++axis) {
        if (m_place[axis] < low[axis] || m_place[axis] > high[axis]) {
            m_place[axis] = std::clamp(m_place[axis], low[axis], high[axis]);
            m_velocity[axis] = 0.0;
        }
    }
    const double turn = std::abs(m_wish.jawSpeed_rad_per_s) * dt;
    m_jaw_rad = std::clamp(m_jaw_rad + std::clamp(m_wish.jaw_rad - m_jaw_rad, -turn, turn), 0.0, kWidest_rad);
    mechanisms::HandIntention wanted;
    wanted.p_DDesired = m_place;
    wanted.v_DDesired = m_velocity;
    wanted.jaw_rad = m_jaw_rad;
    return wanted;
} }

} // namespace chiron::operators
