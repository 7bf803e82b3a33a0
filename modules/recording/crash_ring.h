// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "core/result.h"
#include "recording/crc32c.h"
#include "recording/ring_file.h"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace chiron::recording {

/// Returns $XDG_RUNTIME_DIR if it is a writable folder, otherwise /dev/shm.
std::filesystem::path defaultRingFolder();

/// Holds the last seconds of a session in a file mapping that outlives the process (data.md, The crash ring).
/// The haptic thread writes: tryPush() copies the used tools and makes no system call. A frame stays in the
/// ring until the drain reports it as committed. Neither copyable nor movable, because it owns the mapping
/// and the lock.
class CrashRing final : public core::IFrameSink {
public:
    /// Creates, allocates, faults in and locks the file.
    /// Errors: storage if there is too little room (no file is left behind); wrongUse for bad settings.
    static core::Result<std::unique_ptr<CrashRing>> create(const RingSettings& settings);
    CrashRing(const CrashRing&) = delete;
    CrashRing& operator=(const CrashRing&) = delete;
    ~CrashRing() override; ///< unmaps and unlocks; the file stays for recovery unless remove() was called

    /// Returns false, and counts the loss, if the committed frames lag a whole ring behind or the frame has
    /// another number of tools than the ring.
    /// Thread: haptic.
    bool tryPush(const core::HapticFrame& frame) noexcept override;

    /// Returns true if the next push will find room. For loops that run faster than real time and may wait.
    /// Thread: haptic.
    bool hasRoom() noexcept;
    std::uint64_t dropped() const noexcept;                  ///< any thread
    std::uint64_t pushed() const noexcept { return m_next; } ///< haptic thread, or after it has stopped
    const std::filesystem::path& path() const noexcept { return m_file.path(); }
    /// Deletes the file. For the normal end of a session, when everything is committed.
    core::Result<void> remove();

private:
    friend class RingDrain;
    explicit CrashRing(RingFile file);
    RingFile m_file;
    CopyWithChecksum m_copy;
    std::uint64_t m_next = 0;          ///< number of the next frame
    std::uint64_t m_committedSeen = 0; ///< the drain's commit mark as last read
};

} // namespace chiron::recording
