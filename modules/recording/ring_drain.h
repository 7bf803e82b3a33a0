// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "recording/crash_ring.h"

#include <cstdint>
#include <span>

namespace chiron::recording {

/// The reading end of a live ring, in the same process. Reading does not free slots; commit() does, so that
/// frames that were read but not yet stored survive a crash. The ring must outlive it.
/// Thread: writer.
class RingDrain {
public:
    explicit RingDrain(CrashRing& ring) noexcept;

    /// Copies frames that were not yet read into `frames`, in order; returns how many. A slot whose checksum
    /// does not match (memory damage) is left out and counted in damaged().
    std::size_t read(std::span<core::HapticFrame> frames) noexcept;
    /// Declares the first `frames` frames of the ring's life as stored permanently: their slots may be
    /// reused.
    void commit(std::uint64_t frames) noexcept;

    std::uint64_t position() const noexcept { return m_next; } ///< slots read so far, damaged ones included
    std::uint64_t dropped() const noexcept { return m_ring.dropped(); }
    std::uint64_t damaged() const noexcept { return m_damaged; }

private:
    CrashRing& m_ring;
    CopyWithChecksum m_copy;
    std::uint64_t m_next = 0;
    std::uint64_t m_damaged = 0;
};

} // namespace chiron::recording
