// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/ring_file.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace chiron::recording {

namespace {
tl::unexpected<core::Error> refused(const std::filesystem::path& path, const std::string& what, int error) {
    return core::fail(core::ErrorCode::storage,
                      "crash ring " + path.string() + ": " + what + ": " + std::strerror(error));
}

core::Result<void> checkSettings(const RingSettings& s) {
    const bool slotsFit =
        std::has_single_bit(s.capacity) && s.capacity >= kMinimumSlots && s.capacity <= kMaximumSlots;
    if (s.tools < 1 || s.tools > core::kMaxTools || !slotsFit)
        return core::fail(core::ErrorCode::wrongUse,
                          "crash ring of " + std::to_string(s.tools) + " tools and " +
                              std::to_string(s.capacity) + " slots, expected 1.." +
                              std::to_string(core::kMaxTools) + " and a power of two in " +
                              std::to_string(kMinimumSlots) + ".." + std::to_string(kMaximumSlots));
    return {};
}
} // namespace

RingFile::RingFile(RingFile&& other) noexcept {
    *this = std::move(other);
}

RingFile& RingFile::operator=(RingFile&& other) noexcept {
    if (this == &other)
        return *this;
    close();
    m_path = std::move(other.m_path);
    m_descriptor = std::exchange(other.m_descriptor, -1);
    m_base = std::exchange(other.m_base, nullptr);
    m_bytes = std::exchange(other.m_bytes, 0);
    m_mask = other.m_mask;
    m_slotBytes = other.m_slotBytes;
    m_tools = other.m_tools;
    return *this;
}

RingFile::~RingFile() {
    close();
}

void RingFile::close() noexcept {
    if (m_base)
        munmap(m_base, m_bytes);
    if (m_descriptor >= 0)
        ::close(m_descriptor); // releases the lock
    m_base = nullptr;
    m_descriptor = -1;
}

core::Result<RingFile> RingFile::create(const RingSettings& settings) {
    CHIRON_TRY(checkSettings(settings));
    RingFile file;
    file.m_tools = static_cast<std::uint32_t>(settings.tools);
    file.m_mask = settings.capacity - 1;
    file.m_slotBytes = slotBytesFor(file.m_tools);
    const std::string name = ringFilePrefix(settings.database) + std::to_string(settings.session);
    const auto part = settings.folder / (name + kUnfinishedRingSuffix);
    CHIRON_TRY(file.make(part, kRingHeaderBytes + settings.capacity * file.m_slotBytes));
    file.writeHeader(settings);
    CHIRON_TRY(file.publish(part, settings.folder / (name + kRingSuffix)));
    return file;
}

// The file is locked from its creation on and complete before it gets its final name, so that no program
// takes it for the ring of a dead program.
core::Result<void> RingFile::make(const std::filesystem::path& part, std::size_t bytes) {
    rlimit limit{};
    // Otherwise the kernel would send SIGXFSZ.
    if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur < bytes)
        return refused(part, "needs " + std::to_string(bytes) + " bytes, the limit on file size forbids it",
                       EFBIG);
    m_descriptor = open(part.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (m_descriptor < 0)
        return refused(part, "cannot be created", errno);
    const auto fail = [&](const std::string& what, int error) {
        unlink(part.c_str());
        return refused(part, what, error);
    };
    if (flock(m_descriptor, LOCK_EX | LOCK_NB) != 0)
        return fail("cannot be locked", errno);
    if (const int error = posix_fallocate(m_descriptor, 0, static_cast<off_t>(bytes)); error != 0)
        return fail("too little room for " + std::to_string(bytes) + " bytes", error);
    void* base = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, m_descriptor, 0);
    if (base == MAP_FAILED)
        return fail("cannot be mapped", errno);
    m_base = static_cast<std::uint8_t*>(base);
    m_bytes = bytes;
    // Every page is written once before the loop writes to it.
    std::memset(m_base, 0, bytes);
    return {};
}

core::Result<void> RingFile::publish(const std::filesystem::path& part, const std::filesystem::path& path) {
    const bool linked = link(part.c_str(), path.c_str()) == 0; // unlike rename, link never replaces an older
                                                               // ring
    const int error = errno;
    unlink(part.c_str());
    if (!linked)
        return refused(path, "cannot be given its name", error);
    m_path = path;
    return {};
}

void RingFile::writeHeader(const RingSettings& settings) noexcept {
    auto* header = new (m_base) RingHeader;
    header->tools = m_tools;
    header->capacity = settings.capacity;
    header->slotBytes = static_cast<std::uint32_t>(m_slotBytes);
    header->database = settings.database;
    header->session = settings.session;
    header->pid = getpid();
    const std::string boot = bootId();
    boot.copy(header->bootId.data(), header->bootId.size() - 1);
    header->checksum = identityChecksum(*header);
}

core::Result<void> RingFile::remove() {
    if (unlink(m_path.c_str()) != 0 && errno != ENOENT)
        return refused(m_path, "cannot be deleted", errno);
    return {};
}

} // namespace chiron::recording
