// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>

namespace chiron::session {

/// What there is room for: on the disk of the database, and where a session's crash ring goes.
struct StorageRoom {
    std::uint64_t database_bytes = 0; ///< with its log
    std::uint64_t diskFree_bytes = 0;
    std::uint64_t disk_bytes = 0;
    std::uint64_t ringFree_bytes = 0;
    std::uint64_t ringNeeded_bytes = 0; ///< by the largest ring of a session
};

enum class RoomState {
    enough,
    low, ///< sessions still run; something should be done
    none ///< a session would be refused, or could not be stored
};

/// Below this much the disk is called low: about three hundred sessions of ten minutes (speed.md: 0.7 MB a minute), and room
/// for a backup of a young site. Assumption.
inline constexpr std::uint64_t kLowDisk_bytes = 2ULL << 30;
/// Below this a session of an hour with its log could not be stored for sure. Assumption.
inline constexpr std::uint64_t kNoDisk_bytes = 128ULL << 20;

/// Reads the sizes as the file systems tell them; what cannot be read is 0. Blocking, short.
StorageRoom storageRoom(const std::filesystem::path& databaseFile, const std::filesystem::path& ringFolder);

RoomState diskState(const StorageRoom& room) noexcept; ///< pure
/// Room for one ring is needed; low below four (other programs share the place). Pure.
RoomState ringState(const StorageRoom& room) noexcept;

} // namespace chiron::session
