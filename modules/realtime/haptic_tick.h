// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::realtime {

class TickSource;

/// Proof that the caller is inside the 1 kHz loop: only a TickSource (owned by the runner) can make one, so a
/// function that takes `const HapticTick&` can be called only from a tick. Such functions are noexcept and do
/// not allocate, lock, log, throw or use Qt.
class HapticTick {
public:
    /// Ticks executed before this one; each is a model step of 1 ms.
    std::uint64_t index() const noexcept { return m_index; }
    /// Monotonic; a missed deadline shows only here.
    std::int64_t now_ns() const noexcept { return m_now_ns; }

private:
    friend class TickSource;
    HapticTick(std::uint64_t index, std::int64_t now_ns) noexcept : m_index(index), m_now_ns(now_ns) {}
    std::uint64_t m_index;
    std::int64_t m_now_ns;
};

/// Makes the ticks of one run, in order. Only a runner should own one.
class TickSource {
public:
    HapticTick next(std::int64_t now_ns) noexcept { return HapticTick(m_next++, now_ns); }
    std::uint64_t executed() const noexcept { return m_next; }

private:
    std::uint64_t m_next = 0;
};

} // namespace chiron::realtime
