// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/ring_recovery.h"

#include "recording/crc32c.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace chiron::recording {

namespace {
using core::ErrorCode;

std::string named(const std::filesystem::path& path) {
    return "crash ring " + path.string() + ": ";
}

/// Uses plain reads instead of a mapping: a file that shrinks meanwhile gives an Error, not a SIGBUS.
bool readAt(int descriptor, std::size_t offset, void* to, std::size_t bytes) noexcept {
    auto* out = static_cast<std::uint8_t*>(to);
    while (bytes > 0) {
        const ssize_t got = pread(descriptor, out, bytes, static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        out += got;
        offset += static_cast<std::size_t>(got);
        bytes -= static_cast<std::size_t>(got);
    }
    return true;
}

/// Returns what is wrong with a header, or an empty text; `fileBytes` is the size of the file.
std::string headerFlaw(const RingHeader& h, std::size_t fileBytes) {
    const auto expected = [](std::size_t offset, const std::string& what) {
        return "byte " + std::to_string(offset) + ": expected " + what;
    };
    if (h.magic != kRingMagic)
        return expected(offsetof(RingHeader, magic), "the mark of a crash ring");
    if (h.version != kRingVersion)
        return expected(offsetof(RingHeader, version),
                        "version " + std::to_string(kRingVersion) + ", found " + std::to_string(h.version));
    if (h.frameLayout != core::kFrameLayoutVersion)
        return expected(offsetof(RingHeader, frameLayout), "frame layout " +
                                                               std::to_string(core::kFrameLayoutVersion) +
                                                               ", found " + std::to_string(h.frameLayout));
    if (h.checksum != identityChecksum(h))
        return expected(offsetof(RingHeader, checksum), "the checksum of the header");
    if (h.tools < 1 || h.tools > core::kMaxTools)
        return expected(offsetof(RingHeader, tools), "1.." + std::to_string(core::kMaxTools) + " tools");
    if (!std::has_single_bit(h.capacity) || h.capacity < kMinimumSlots || h.capacity > kMaximumSlots)
        return expected(offsetof(RingHeader, capacity), "a power of two slots");
    if (h.slotBytes != slotBytesFor(h.tools))
        return expected(offsetof(RingHeader, slotBytes),
                        std::to_string(slotBytesFor(h.tools)) + " bytes a slot");
    const std::size_t whole = kRingHeaderBytes + std::size_t{h.capacity} * h.slotBytes;
    if (fileBytes != whole)
        return expected(std::min(fileBytes, whole),
                        "a file of " + std::to_string(whole) + " bytes, found " + std::to_string(fileBytes));
    return {};
}

/// Returns the frames from the committed mark on, as long as number and checksum of their slots match.
core::Result<std::vector<core::HapticFrame>> uncommitted(int descriptor, const RingHeader& h) {
    std::vector<core::HapticFrame> frames;
    const CopyWithChecksum copy = copyWithChecksum();
    std::array<std::uint8_t, slotBytesFor(core::kMaxTools)> bytes{};
    for (std::uint64_t n = h.committed; n - h.committed < h.capacity; ++n) {
        if (!readAt(descriptor, kRingHeaderBytes + (n % h.capacity) * h.slotBytes, bytes.data(), h.slotBytes))
            return core::fail(ErrorCode::storage,
                              "slot " + std::to_string(n % h.capacity) + " cannot be read");
        SlotHeader slot;
        std::memcpy(&slot, bytes.data(), sizeof(slot));
        core::HapticFrame frame;
        const std::uint32_t found =
            copy(n + 1, &frame, bytes.data() + sizeof(slot), usedFrameBytes(h.tools) / 8);
        if (slot.number != n + 1 || slot.checksum != found || frame.tools != h.tools)
            break;
        frames.push_back(frame);
    }
    return frames;
}

std::vector<std::filesystem::path> listFiles(const std::filesystem::path& folder, const DatabaseId& database,
                                             std::string_view suffix) {
    std::vector<std::filesystem::path> found;
    const std::string prefix = ringFilePrefix(database);
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        const std::string name = it->path().filename().string();
        if (name.starts_with(prefix) && name.ends_with(suffix))
            found.push_back(it->path());
    }
    std::sort(found.begin(), found.end());
    return found;
}
} // namespace

RecoveredRing::RecoveredRing(RecoveredRing&& other) noexcept {
    *this = std::move(other);
}

RecoveredRing& RecoveredRing::operator=(RecoveredRing&& other) noexcept {
    if (this == &other)
        return *this;
    if (m_descriptor >= 0)
        close(m_descriptor);
    m_path = std::move(other.m_path);
    m_descriptor = std::exchange(other.m_descriptor, -1);
    m_header = other.m_header;
    m_frames = std::move(other.m_frames);
    return *this;
}

RecoveredRing::~RecoveredRing() {
    if (m_descriptor >= 0)
        close(m_descriptor);
}

bool RecoveredRing::sameBoot() const {
    const std::size_t length = strnlen(m_header.bootId.data(), m_header.bootId.size());
    return length > 0 && std::string_view(m_header.bootId.data(), length) == bootId();
}

core::Result<void> RecoveredRing::remove() {
    if (unlink(m_path.c_str()) != 0 && errno != ENOENT)
        return core::fail(ErrorCode::storage, named(m_path) + "cannot be deleted: " + std::strerror(errno));
    return {};
}

core::Result<RecoveredRing> recoverRing(const std::filesystem::path& path) {
    RecoveredRing ring;
    ring.m_path = path;
    ring.m_descriptor = open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (ring.m_descriptor < 0)
        return core::fail(errno == ENOENT ? ErrorCode::notFound : ErrorCode::storage,
                          named(path) + "cannot be opened: " + std::strerror(errno));
    if (flock(ring.m_descriptor, LOCK_EX | LOCK_NB) != 0)
        return core::fail(errno == EWOULDBLOCK ? ErrorCode::locked : ErrorCode::storage,
                          named(path) + "its program is still running, or another one recovers it");
    struct stat about {};
    if (fstat(ring.m_descriptor, &about) != 0 || !S_ISREG(about.st_mode))
        return core::fail(ErrorCode::badInput, named(path) + "expected a regular file");
    // Another program was faster: it recovered and deleted the ring between open and lock.
    if (about.st_nlink == 0)
        return core::fail(ErrorCode::notFound, named(path) + "was recovered by another program");
    const auto bytes = static_cast<std::size_t>(about.st_size);
    if (bytes < kRingHeaderBytes || !readAt(ring.m_descriptor, 0, &ring.m_header, sizeof(RingHeader)))
        return core::fail(ErrorCode::badInput, named(path) + "byte " + std::to_string(bytes) +
                                                   ": expected a header of " +
                                                   std::to_string(kRingHeaderBytes) + " bytes");
    if (const std::string flaw = headerFlaw(ring.m_header, bytes); !flaw.empty())
        return core::fail(ErrorCode::badInput, named(path) + flaw);
    auto frames = uncommitted(ring.m_descriptor, ring.m_header);
    if (!frames)
        return core::fail(frames.error().code, named(path) + frames.error().message);
    ring.m_frames = std::move(*frames);
    return ring;
}

std::vector<std::filesystem::path> listRings(const std::filesystem::path& folder,
                                             const DatabaseId& database) {
    return listFiles(folder, database, kRingSuffix);
}

int removeUnfinishedRings(const std::filesystem::path& folder, const DatabaseId& database) {
    int removed = 0;
    for (const auto& path : listFiles(folder, database, kUnfinishedRingSuffix)) {
        const int descriptor = open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
        if (descriptor < 0)
            continue;
        if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 && unlink(path.c_str()) == 0)
            ++removed;
        close(descriptor);
    }
    return removed;
}

} // namespace chiron::recording
