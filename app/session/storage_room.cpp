// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/storage_room.h"

#include "recording/ring_layout.h"

#include <system_error>

namespace chiron::session {

namespace {

std::uint64_t sizeOf(const std::filesystem::path& file) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    return error ? 0 : size;
}

std::filesystem::space_info spaceAt(const std::filesystem::path& folder) {
    std::error_code error;
    const auto space = std::filesystem::space(folder, error);
    return error ? std::filesystem::space_info{} : space;
}

} // namespace

StorageRoom storageRoom(const std::filesystem::path& databaseFile, const std::filesystem::path& ringFolder) {
    StorageRoom room;
    std::filesystem::path log = databaseFile;
    log += "-wal";
    room.database_bytes = sizeOf(databaseFile) + sizeOf(log);
    const auto disk = spaceAt(databaseFile.parent_path());
    room.diskFree_bytes = disk.available;
    room.disk_bytes = disk.capacity;
    room.ringFree_bytes = spaceAt(ringFolder).available;
    room.ringNeeded_bytes =
        recording::kRingHeaderBytes + recording::kMinimumSlots * recording::slotBytesFor(core::kMaxTools);
    return room;
}

RoomState diskState(const StorageRoom& room) noexcept {
    if (room.diskFree_bytes < kNoDisk_bytes)
        return RoomState::none;
    return room.diskFree_bytes < kLowDisk_bytes ? RoomState::low : RoomState::enough;
}

RoomState ringState(const StorageRoom& room) noexcept {
    if (room.ringFree_bytes < room.ringNeeded_bytes)
        return RoomState::none;
    return room.ringFree_bytes < 4 * room.ringNeeded_bytes ? RoomState::low : RoomState::enough;
}

} // namespace chiron::session
