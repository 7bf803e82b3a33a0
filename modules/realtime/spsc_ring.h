// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <type_traits>

namespace chiron::realtime {

/// A wait-free queue from one producer to one consumer, N a power of two. Indices run freely and are masked; each side
/// keeps a cached copy of the other's index and reads the shared one only when the cache says full or empty, so that a
/// push costs one release store. Never allocates after construction. Thread: tryPush() by one thread, tryPop() by one other.
template <class T, std::size_t N>
class SpscRing {
    static_assert(N >= 2 && (N & (N - 1)) == 0, "the capacity is a power of two");
    static_assert(std::is_trivially_copyable_v<T>, "only values that can be copied bytewise travel between threads");

public:
    SpscRing() = default;
    SpscRing(const SpscRing&) = delete;
    SpscRing& operator=(const SpscRing&) = delete;

    /// Producer only. False when full: nothing was stored, the caller counts it.
    bool tryPush(const T& value) noexcept {
        const std::size_t tail = m_tail.load(std::memory_order_relaxed);
        if (tail - m_cachedHead == N) {
            m_cachedHead = m_head.load(std::memory_order_acquire);
            if (tail - m_cachedHead == N)
                return false;
        }
        m_slots[tail & (N - 1)] = value;
        m_tail.store(tail + 1, std::memory_order_release);
        return true;
    }

    /// Consumer only. False when empty: `value` is untouched.
    bool tryPop(T& value) noexcept {
        const std::size_t head = m_head.load(std::memory_order_relaxed);
        if (head == m_cachedTail) {
            m_cachedTail = m_tail.load(std::memory_order_acquire);
            if (head == m_cachedTail)
                return false;
        }
        value = m_slots[head & (N - 1)];
        m_head.store(head + 1, std::memory_order_release);
        return true;
    }

    static constexpr std::size_t capacity() noexcept { return N; }

private:
    alignas(64) std::atomic<std::size_t> m_head{0}; // consumer's line
    std::size_t m_cachedTail = 0;
    alignas(64) std::atomic<std::size_t> m_tail{0}; // producer's line
    std::size_t m_cachedHead = 0;
    alignas(64) std::array<T, N> m_slots{};
};

} // namespace chiron::realtime
