// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

/// Counts what a tick must not do. The program that links tick_guard.cpp has its own malloc, free,
/// pthread_mutex_lock,
/// __cxa_throw and so on, which pass on to the C library and, while the calling thread is inside a TickGuard,
/// count.
namespace chiron::tests {

enum class Forbidden { allocate, release, lock, notify, raise, write };
inline constexpr std::array<const char*, 6> kForbiddenNames{"allocate", "free",  "lock",
                                                            "notify",   "throw", "write"};

struct ForbiddenCounts {
    std::array<std::uint64_t, kForbiddenNames.size()> count{};
    std::uint64_t of(Forbidden kind) const { return count[static_cast<std::size_t>(kind)]; }
    std::uint64_t total() const;
};

/// While one lives, the calling thread's forbidden calls are counted. Not nested.
class TickGuard {
public:
    TickGuard() noexcept;
    ~TickGuard();
    TickGuard(const TickGuard&) = delete;
    TickGuard& operator=(const TickGuard&) = delete;
};

ForbiddenCounts forbiddenCounts() noexcept; ///< of this thread since resetForbiddenCounts()
void resetForbiddenCounts() noexcept;

} // namespace chiron::tests
