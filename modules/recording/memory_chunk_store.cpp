// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/memory_chunk_store.h"

namespace chiron::recording {

core::Result<void> MemoryChunkStore::write(std::span<const Chunk> chunks,
                                           std::span<const SecondSummary> summaries) {
    m_chunks.insert(m_chunks.end(), chunks.begin(), chunks.end());
    m_summaries.insert(m_summaries.end(), summaries.begin(), summaries.end());
    return {};
}

core::Result<Chunk> MemoryChunkStore::chunk(std::size_t sequence) {
    if (sequence >= m_chunks.size())
        return core::fail(core::ErrorCode::notFound,
                          "chunk " + std::to_string(sequence) + " of " + std::to_string(m_chunks.size()));
    return m_chunks[sequence];
}

} // namespace chiron::recording
