// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/ring_layout.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace chiron::recording {

struct RingSettings {
    std::filesystem::path folder; ///< memory-backed, because the haptic thread writes to it:
                                  ///< defaultRingFolder()
    DatabaseId database{};
    std::int64_t session = 0;
    int tools = 1;                 ///< 1..kMaxTools; decides the slot size
    std::uint32_t capacity = 4096; ///< a power of two, kMinimumSlots..kMaximumSlots: at least 4 s at 1 kHz
};

/// A ring file that is created, fully allocated, faulted in, mapped and locked. Every page has been touched
/// before, so access makes no page fault and raises no SIGBUS. Move-only. Only create() blocks.
class RingFile {
public:
    /// Creates the file.
    /// Errors: wrongUse for settings out of range; storage if the file cannot be made or there is too little
    /// room for all of it (then no file is left behind).
    static core::Result<RingFile> create(const RingSettings& settings);
    RingFile(const RingFile&) = delete;
    RingFile& operator=(const RingFile&) = delete;
    RingFile(RingFile&& other) noexcept;
    RingFile& operator=(RingFile&& other) noexcept;
    ~RingFile();

    RingHeader& header() const noexcept { return *reinterpret_cast<RingHeader*>(m_base); }
    /// Returns the slot of the ring's n-th frame (n counts from 0 and never wraps).
    std::uint8_t* slot(std::uint64_t n) const noexcept {
        return m_base + kRingHeaderBytes + (n & m_mask) * m_slotBytes;
    }
    std::uint64_t capacity() const noexcept { return m_mask + 1; }
    std::uint32_t tools() const noexcept { return m_tools; }
    const std::filesystem::path& path() const noexcept { return m_path; }
    /// Deletes the file; the mapping stays usable as long as this object exists.
    /// Errors: storage.
    core::Result<void> remove();

private:
    RingFile() = default;
    core::Result<void> make(const std::filesystem::path& part, std::size_t bytes);
    core::Result<void> publish(const std::filesystem::path& part, const std::filesystem::path& path);
    void writeHeader(const RingSettings& settings) noexcept;
    void close() noexcept;

    std::filesystem::path m_path;
    int m_descriptor = -1;
    std::uint8_t* m_base = nullptr;
    std::size_t m_bytes = 0;
    std::uint64_t m_mask = 0;
    std::size_t m_slotBytes = 0;
    std::uint32_t m_tools = 0;
};

} // namespace chiron::recording
