// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <type_traits>

namespace chiron::realtime {

/// A wait-free queue from one producer to one consumer; N is a power of two. The indices run freely and are
/// masked. Each side keeps a cached copy of the other's index and reads the shared one only when the copy
/// says full or empty, so that a push costs one release store.
/// Thread: tryPush() on one thread, tryPop() on one other; allocates nothing after construction.
template <class T, std::size_t N> class SpscRing {
    static_assert(N >= 2 && (N & (N - 1)) == 0, "the capacity is a power of two");
    static_assert(std::is_trivially_copyable_v<T>,
                  "only values that can be copied bytewise travel between threads");

public:
    SpscRing() = default;
    SpscRing(const SpscRing&) = delete;
    SpscRing& operator=(const SpscRing&) = delete;

    /// Producer only. Returns false if the ring is full: nothing was stored, and the caller counts the loss.
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

    /// Consumer only. Returns false if the ring is empty; `value` is unchanged.
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
    alignas(64) std::atomic<std::size_t> m_head{0}; // the consumer's cache line
    std::size_t m_cachedTail = 0;
    alignas(64) std::atomic<std::size_t> m_tail{0}; // the producer's cache line
    std::size_t m_cachedHead = 0;
    alignas(64) std::array<T, N> m_slots{};
};

} // namespace chiron::realtime
