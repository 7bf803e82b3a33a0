// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace chiron::recording {

using Digest = std::array<std::uint8_t, 32>; ///< BLAKE2b-256 (libsodium crypto_generichash)

/// Summary of one second of one tool. It is stored beside the chunks, so that queries over thousands of
/// sessions need no samples.
struct SecondSummary {
    std::uint32_t second = 0; ///< floor(device time since the first frame / 1 s)
    std::uint8_t tool = 0;
    std::uint32_t frames = 0; ///< unpaused frames
    double pathLength_m = 0.0;
    double maximumForce_N = 0.0;  ///< tissue
    double meanForce_N = 0.0;     ///< tissue, over frames
    double impulse_Ns = 0.0;      ///< ∫‖tissue force‖ dt
    double timeOverLimit_s = 0.0; ///< time in which the tissue force exceeds the session's limit
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

/// Destination of chunks; implemented by the database.
/// Thread: writer.
class TrialSink {
public:
    virtual ~TrialSink() = default;
    /// Stores a batch in one transaction: all or nothing. It replaces an existing summary of the same tool
    /// and second (which exists only after a crash between the last write and the end of the session).
    virtual core::Result<void> write(std::span<const Chunk> chunks,
                                     std::span<const SecondSummary> summaries) = 0;
};

/// Source of chunks: a stored session, a bundle or memory.
class ChunkSource {
public:
    virtual ~ChunkSource() = default;
    virtual core::Result<std::vector<std::uint8_t>> channelTable() = 0; ///< encoded (channel_table.h)
    virtual std::size_t chunkCount() const = 0;
    virtual core::Result<Chunk>
    chunk(std::size_t sequence) = 0; ///< the reader checks the digest, not this function
};

} // namespace chiron::recording
