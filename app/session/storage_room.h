// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>

namespace chiron::session {

/// The free space on the disk of the database and at the location of a session's crash ring.
struct StorageRoom {
    std::uint64_t database_bytes = 0; ///< including its log
    std::uint64_t diskFree_bytes = 0;
    std::uint64_t disk_bytes = 0;
    std::uint64_t ringFree_bytes = 0;
    std::uint64_t ringNeeded_bytes = 0; ///< size of the largest ring of a session
};

enum class RoomState {
    enough,
    low, ///< sessions still run, but somebody should free space
    none ///< a session would be refused or could not be stored
};

/// Below this size the free space is low: it holds about three hundred sessions of ten minutes (speed.md: 0.7
/// MB per minute) and a backup of a young site. Assumption.
inline constexpr std::uint64_t kLowDisk_bytes = 2ULL << 30;
/// Below this size it is not certain that a session of one hour with its log can be stored. Assumption.
inline constexpr std::uint64_t kNoDisk_bytes = 128ULL << 20;

/// Reads the sizes that the file systems report; sizes that cannot be read are 0. Blocks for a short time.
StorageRoom storageRoom(const std::filesystem::path& databaseFile, const std::filesystem::path& ringFolder);

RoomState diskState(const StorageRoom& room) noexcept; ///< pure
/// One ring must fit; below four the state is low, because other programs share the space. Pure function.
RoomState ringState(const StorageRoom& room) noexcept;

} // namespace chiron::session
