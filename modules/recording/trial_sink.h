// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace chiron::recording {

using Digest = std::array<std::uint8_t, 32>; ///< BLAKE2b-256 (libsodium crypto_generichash)

/// One second of one tool, kept beside the chunks so that questions over thousands of sessions need no
/// samples.
struct SecondSummary {
    std::uint32_t second = 0; ///< floor(device time since the first frame / 1 s)
    std::uint8_t tool = 0;
    std::uint32_t frames = 0; ///< not paused
    double pathLength_m = 0.0;
    double maximumForce_N = 0.0;  ///< tissue
    double meanForce_N = 0.0;     ///< tissue, over frames
    double impulse_Ns = 0.0;      ///< ∫‖tissue force‖ dt
    double timeOverLimit_s = 0.0; ///< tissue force over the session's limit
    std::uint32_t events = 0;     ///< OR of event bits
};

/// A closed chunk: consecutive executed ticks, encoded (chunk_encoder.h).
struct Chunk {
    std::uint32_t sequence = 0; ///< 0, 1, 2 ... in one session
    std::uint64_t firstTick = 0;
    std::uint32_t frames = 0;
    std::vector<std::uint8_t> payload;
    Digest payloadDigest{}; ///< payloadDigestOf (digest.h)
    Digest forceHash{};     ///< forceHashOf (digest.h)
};

/// Where chunks go; implemented by the database. Called on the writer thread only.
class TrialSink {
public:
    virtual ~TrialSink() = default;
    /// Stores a batch in one transaction: all or nothing. A summary of a (tool, second) that is there already
    /// (only after a crash between the last write and the end of the session) is replaced.
    virtual core::Result<void> write(std::span<const Chunk> chunks,
                                     std::span<const SecondSummary> summaries) = 0;
};

/// Where chunks come from: a stored session, a bundle, memory.
class ChunkSource {
public:
    virtual ~ChunkSource() = default;
    virtual core::Result<std::vector<std::uint8_t>> channelTable() = 0; ///< encoded (channel_table.h)
    virtual std::size_t chunkCount() const = 0;
    virtual core::Result<Chunk>
    chunk(std::size_t sequence) = 0; ///< digest is checked by the reader, not here
};

} // namespace chiron::recording
