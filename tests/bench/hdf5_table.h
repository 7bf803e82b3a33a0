// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

#include <filesystem>
#include <span>

namespace chiron::bench {

/// The other peer: an HDF5 dataset of 24 doubles a sample, chunks of one second, shuffle and deflate 1,
/// appended and flushed once a second. Not measured where the library is missing.
class Hdf5Table {
public:
    static bool available();
    static void write(const std::filesystem::path& file, std::span<const core::HapticFrame> frames);
    static double readSpan(const std::filesystem::path& file, std::uint64_t first, std::uint64_t frames);
    static double scanOne(const std::filesystem::path& file);
};

} // namespace chiron::bench
