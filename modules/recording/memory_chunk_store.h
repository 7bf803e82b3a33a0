// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/channel_table.h"
#include "recording/trial_sink.h"

#include <vector>

namespace chiron::recording {

/// A recording in memory: for replays, exports and tests. Copyable. Not synchronised.
class MemoryChunkStore final : public TrialSink, public ChunkSource {
public:
    explicit MemoryChunkStore(std::vector<std::uint8_t> encodedTable) : m_table(std::move(encodedTable)) {}

    core::Result<void> write(std::span<const Chunk> chunks,
                             std::span<const SecondSummary> summaries) override;
    core::Result<std::vector<std::uint8_t>> channelTable() override { return m_table; }
    std::size_t chunkCount() const override { return m_chunks.size(); }
    core::Result<Chunk> chunk(std::size_t sequence) override;

    std::vector<Chunk>& chunks() noexcept { return m_chunks; }
    const std::vector<SecondSummary>& summaries() const noexcept { return m_summaries; }

private:
    std::vector<std::uint8_t> m_table;
    std::vector<Chunk> m_chunks;
    std::vector<SecondSummary> m_summaries;
};

} // namespace chiron::recording
