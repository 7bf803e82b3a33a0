// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/memory_chunk_store.h"
#include "recording/recorder.h"
#include "support/haptic_trace.h"

namespace chiron::tests {

using namespace chiron::recording;

/// Of a cartesian tool at 10 um a count.
struct Position final : IPositionOf {
    core::Vec3 p_WT_m(int, const core::ToolFrame& frame) const noexcept override {
        return 1e-5 * core::Vec3(frame.counts[0], frame.counts[1], frame.counts[2]);
    }
};

/// Refuses while `full`.
struct Sink final : TrialSink {
    explicit Sink(MemoryChunkStore& to) : store(to) {}
    MemoryChunkStore& store;
    bool full = false;
    int calls = 0;
    core::Result<void> write(std::span<const Chunk> chunks,
                             std::span<const SecondSummary> summaries) override {
        ++calls;
        if (full)
            return core::fail(core::ErrorCode::storage, "disk full");
        return store.write(chunks, summaries);
    }
};

struct Fixture {
    explicit Fixture(int tools = 1)
        : table(*ChannelTable::forTools(HapticTrace::channels(tools))), store(table.encode()), sink(store) {
        settings.forceLimit_N = 0.8;
    }
    ChannelTable table;
    MemoryChunkStore store;
    Sink sink;
    Position position;
    RecorderSettings settings;
    Recorder recorder() { return Recorder(table, position, sink, settings); }
};

/// To the last bit.
inline bool sameSummary(const SecondSummary& a, const SecondSummary& b) {
    return a.second == b.second && a.tool == b.tool && a.frames == b.frames &&
           a.pathLength_m == b.pathLength_m && a.maximumForce_N == b.maximumForce_N &&
           a.meanForce_N == b.meanForce_N && a.impulse_Ns == b.impulse_Ns &&
           a.timeOverLimit_s == b.timeOverLimit_s && a.events == b.events;
}

} // namespace chiron::tests
