// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/crash_ring.h"
#include "recording/ring_drain.h"
#include "support/haptic_trace.h"

#include <QTemporaryDir>
#include <filesystem>
#include <fstream>

namespace chiron::tests {

using namespace chiron::recording;

/// A folder that goes away, and settings for ring after ring in it.
struct RingFolder {
    QTemporaryDir folder;
    std::int64_t session = 0;
    RingSettings settings(int tools = 1) {
        RingSettings s;
        s.folder = folder.path().toStdString();
        s.database = {0xde, 0xad, 0xbe, 0xef, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
        s.session = ++session;
        s.tools = tools;
        return s;
    }
};

/// Flips bits of one byte of a file.
inline void patch(const std::filesystem::path& path, std::size_t offset, std::uint8_t flip) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(static_cast<std::streamoff>(offset));
    const auto byte = static_cast<std::uint8_t>(file.get());
    file.seekp(static_cast<std::streamoff>(offset));
    file.put(static_cast<char>(byte ^ flip));
}

/// The ring of a program that died after so many frames.
inline std::filesystem::path leaveBehind(const RingSettings& settings, std::size_t frames,
                                         std::uint64_t committed) {
    auto ring = CrashRing::create(settings);
    HapticTrace trace(1, settings.tools);
    RingDrain drain(**ring);
    drain.commit(committed);
    for (std::size_t i = 0; i < frames; ++i)
        (*ring)->tryPush(trace.next());
    return (*ring)->path();
}

} // namespace chiron::tests
