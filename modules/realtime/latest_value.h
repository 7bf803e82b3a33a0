// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace chiron::realtime {

/// Passes the newest value from one writer to one reader through a triple buffer. Writer and reader never
/// wait for each other and never allocate. The reader never sees a partly written value or one older than it
/// saw before; values in between are lost on purpose.
/// Thread: publish() on one thread, read() and latest() on one other.
///
/// Of the three slots the writer owns one and the reader one; `m_middle` holds the index of the third and a
/// bit that says whether that slot is new. Each side exchanges its slot with the middle one (Simpson 1990
/// describes the family; the exchange form needs no sequence numbers).
template <class T> class LatestValue {
    static_assert(std::is_trivially_copyable_v<T>,
                  "only values that can be copied bytewise travel between threads");

public:
    explicit LatestValue(const T& initial = T{}) noexcept
        : m_slots{Slot{initial}, Slot{initial}, Slot{initial}} {}
    LatestValue(const LatestValue&) = delete;
    LatestValue& operator=(const LatestValue&) = delete;

    /// Writer only; wait-free.
    void publish(const T& value) noexcept {
        m_slots[m_writing].value = value;
        m_writing =
            m_middle.exchange(static_cast<std::uint8_t>(m_writing | kNews), std::memory_order_acq_rel) &
            kIndexMask;
    }

    /// Reader only; wait-free. Copies the newest value; returns true if it was not read before.
    bool read(T& value) noexcept {
        const bool news = refresh();
        value = m_slots[m_reading].value;
        return news;
    }

    /// Reader only. Returns the newest value in place; it is valid until the next read() or latest().
    const T& latest() noexcept {
        refresh();
        return m_slots[m_reading].value;
    }

private:
    static constexpr std::uint8_t kNews = 4;
    static constexpr std::uint8_t kIndexMask = 3;
    struct alignas(64) Slot { // a cache line of its own: no false sharing between writer and reader
        T value;
    };

    bool refresh() noexcept {
        if ((m_middle.load(std::memory_order_relaxed) & kNews) == 0)
            return false;
        m_reading = m_middle.exchange(m_reading, std::memory_order_acq_rel) & kIndexMask;
        return true;
    }

    std::array<Slot, 3> m_slots;
    alignas(64) std::uint8_t m_writing = 0;
    alignas(64) std::atomic<std::uint8_t> m_middle{1};
    alignas(64) std::uint8_t m_reading = 2;
};

} // namespace chiron::realtime
