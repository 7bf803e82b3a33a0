// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "core/result.h"
#include "recording/ring_layout.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace chiron::recording {

/// The contents of a ring whose program has died. It holds the file's lock, so that two programs never
/// recover the same ring. Move-only.
class RecoveredRing {
public:
    RecoveredRing(const RecoveredRing&) = delete;
    RecoveredRing& operator=(const RecoveredRing&) = delete;
    RecoveredRing(RecoveredRing&& other) noexcept;
    RecoveredRing& operator=(RecoveredRing&& other) noexcept;
    ~RecoveredRing();

    const DatabaseId& database() const noexcept { return m_header.database; }
    std::int64_t session() const noexcept { return m_header.session; }
    std::int64_t pid() const noexcept { return m_header.pid; } ///< of the program that died
    int tools() const noexcept { return static_cast<int>(m_header.tools); }
    /// Frames that the drain had marked as stored.
    std::uint64_t committed() const noexcept { return m_header.committed; }
    /// Lost because the ring was full; if not 0, the recording is incomplete.
    std::uint64_t dropped() const noexcept { return m_header.dropped; }
    /// False if the machine was restarted since; then the newest samples may be missing.
    bool sameBoot() const;
    /// The frames after the committed ones, in order, up to the first slot that is missing or damaged. The
    /// mark may lag behind the database by one batch, so leave out ticks that are already stored
    /// (Recorder::resume does this).
    const std::vector<core::HapticFrame>& frames() const noexcept { return m_frames; }
    /// Deletes the file; call it once the frames are stored.
    core::Result<void> remove();

private:
    friend core::Result<RecoveredRing> recoverRing(const std::filesystem::path& path);
    RecoveredRing() = default;
    std::filesystem::path m_path;
    int m_descriptor = -1;
    RingHeader m_header;
    std::vector<core::HapticFrame> m_frames;
};

/// Reads a ring whose program has died. The caller holds the database lock.
/// Errors: locked if its program still runs; badInput if the file is not a ring of this layout (naming offset
/// and expectation); notFound if the file does not exist; storage if it cannot be read.
core::Result<RecoveredRing> recoverRing(const std::filesystem::path& path);

/// Lists the rings of one database in a folder, of live and dead programs, by file name; a missing folder has
/// none.
std::vector<std::filesystem::path> listRings(const std::filesystem::path& folder, const DatabaseId& database);

/// Removes unfinished rings of the database, whose program died while creating them. Returns how many.
int removeUnfinishedRings(const std::filesystem::path& folder, const DatabaseId& database);

} // namespace chiron::recording
