// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/crash_ring.h"

#include <atomic>
#include <cstdlib>
#include <unistd.h>

namespace chiron::recording {

static_assert(std::atomic_ref<std::uint64_t>::is_always_lock_free);

std::filesystem::path defaultRingFolder() {
    const char* runtime = std::getenv("XDG_RUNTIME_DIR");
    std::error_code error;
    if (runtime && *runtime && std::filesystem::is_directory(runtime, error) &&
        access(runtime, W_OK | X_OK) == 0)
        return runtime;
    return "/dev/shm";
}

CrashRing::CrashRing(RingFile file) : m_file(std::move(file)), m_copy(copyWithChecksum()) {}
CrashRing::~CrashRing() = default;

core::Result<std::unique_ptr<CrashRing>> CrashRing::create(const RingSettings& settings) {
    auto file = RingFile::create(settings);
    CHIRON_TRY(file);
    return std::unique_ptr<CrashRing>(new CrashRing(std::move(*file)));
}

bool CrashRing::hasRoom() noexcept {
    if (m_next - m_committedSeen < m_file.capacity()) [[likely]]
        return true;
    m_committedSeen = std::atomic_ref(m_file.header().committed).load(std::memory_order_acquire);
    return m_next - m_committedSeen < m_file.capacity();
}

bool CrashRing::tryPush(const core::HapticFrame& frame) noexcept {
    if (frame.tools != m_file.tools() || !hasRoom()) [[unlikely]] {
        std::atomic_ref dropped(m_file.header().dropped); // only this thread writes it
        dropped.store(dropped.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        return false;
    }
    std::uint8_t* bytes = m_file.slot(m_next);
    auto* slot = reinterpret_cast<SlotHeader*>(bytes);
    const std::uint64_t number = m_next + 1;
    slot->checksum = m_copy(number, bytes + sizeof(SlotHeader), &frame, usedFrameBytes(frame.tools) / 8);
    std::atomic_ref(slot->number).store(number, std::memory_order_release);
    m_next = number;
    return true;
}

std::uint64_t CrashRing::dropped() const noexcept {
    return std::atomic_ref(m_file.header().dropped).load(std::memory_order_relaxed);
}

core::Result<void> CrashRing::remove() {
    return m_file.remove();
}

} // namespace chiron::recording
