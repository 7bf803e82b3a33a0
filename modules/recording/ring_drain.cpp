// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/ring_drain.h"

#include <atomic>

namespace chiron::recording {

RingDrain::RingDrain(CrashRing& ring) noexcept : m_ring(ring), m_copy(copyWithChecksum()) {}

std::size_t RingDrain::read(std::span<core::HapticFrame> frames) noexcept {
    const RingFile& file = m_ring.m_file;
    std::size_t count = 0;
    while (count < frames.size()) {
        std::uint8_t* bytes = file.slot(m_next);
        auto* slot = reinterpret_cast<SlotHeader*>(bytes);
        if (std::atomic_ref(slot->number).load(std::memory_order_acquire) != m_next + 1)
            break;
        core::HapticFrame& frame = frames[count];
        if (frame.tools != file.tools())
            frame = {}; // clears the tools that the slot does not hold
        const std::uint32_t found =
            m_copy(m_next + 1, &frame, bytes + sizeof(SlotHeader), usedFrameBytes(file.tools()) / 8);
        ++m_next;
        if (found == slot->checksum && frame.tools == file.tools())
            ++count;
        else
            ++m_damaged;
    }
    return count;
}

void RingDrain::commit(std::uint64_t frames) noexcept {
    std::atomic_ref(m_ring.m_file.header().committed).store(frames, std::memory_order_release);
}

} // namespace chiron::recording
