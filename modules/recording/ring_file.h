// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/ring_layout.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace chiron::recording {

struct RingSettings;

/// A created, fully allocated, mapped and locked ring file. Move-only. Everything blocking is in create().
class RingFile {
public:
    static core::Result<RingFile> create(const RingSettings& settings);
    RingFile(const RingFile&) = delete;
    RingFile& operator=(const RingFile&) = delete;
    RingFile(RingFile&& other) noexcept;
    RingFile& operator=(RingFile&& other) noexcept;
    ~RingFile();

    RingHeader& header() const noexcept { return *reinterpret_cast<RingHeader*>(m_base); }
    std::uint8_t* slot(std::uint64_t number) const noexcept {
        return m_base + kRingHeaderBytes + (number & m_mask) * m_slotBytes;
    }
    std::uint64_t slots() const noexcept { return m_mask + 1; }
    std::uint32_t tools() const noexcept { return m_tools; }
    const std::filesystem::path& path() const noexcept { return m_path; }
    core::Result<void> remove();

private:
    RingFile() = default;
    core::Result<void> allocate(std::size_t bytes);
    void writeHeader(const RingSettings& settings);
    void close() noexcept;

    std::filesystem::path m_path;
    int m_descriptor = -1;
    std::uint8_t* m_base = nullptr;
    std::size_t m_bytes = 0;
    std::uint64_t m_mask = 0;
    std::size_t m_slotBytes = 0;
    std::uint32_t m_tools = 0;
};

/// File name of a ring: chiron-<uuid>-<session>.ring
std::string ringFileName(const DatabaseId& database, std::int64_t session);
/// This boot's id as the kernel gives it; empty if there is none.
std::string bootId();

} // namespace chiron::recording
