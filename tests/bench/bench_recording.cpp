// SPDX-License-Identifier: GPL-3.0-or-later
// Recording beside its peers on the same minute (writing) and ten minutes (reading) of one tool at 1 kHz.
// Prints medians of CPU time and their ratios; asserts no time.
#include "bench/alternating.h"
#include "bench/hdf5_table.h"
#include "bench/sqlite_chunks.h"
#include "bench/sqlite_rows.h"
#include "recording/digest.h"
#include "recording/frame_drain.h"
#include "recording/memory_chunk_store.h"
#include "recording/recording_reader.h"
#include "support/haptic_trace.h"

#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <unistd.h>

using namespace chiron;
using namespace chiron::recording;
using namespace chiron::bench;

namespace {
constexpr const char* kRingFolder = "/dev/shm";
constexpr int kRepeats = 7;
constexpr std::size_t kMinute = 60'000;
constexpr std::size_t kTenMinutes = 600'000;

struct Position final : IPositionOf {
    core::Vec3 p_WT_m(int, const core::ToolFrame& f) const noexcept override {
        return 1e-5 * core::Vec3(f.counts[0], f.counts[1], f.counts[2]);
    }
};

void report(const char* work, const char* unit, const std::vector<double>& peer,
            const std::vector<double>& ours, const char* goal) {
    const double p = median(peer), o = median(ours);
    std::printf("%-58s %10.3f %10.3f %-10s %8.1f  %s\n", work, p, o, unit, p / o, goal);
}

std::uintmax_t sizeOf(const std::filesystem::path& file) {
    return std::filesystem::file_size(file);
}

void removeAll(const std::filesystem::path& file) {
    for (const char* suffix : {"", "-wal", "-shm"})
        std::filesystem::remove(file.string() + suffix);
}

/// Calls work with 200 frames of the input after another, read from memory beforehand as a loop's own frames
/// are; the CPU time of the work alone.
template <class Work> double onWarmFrames(std::span<const core::HapticFrame> frames, Work&& work) {
    std::vector<core::HapticFrame> some(200);
    double spent = 0.0;
    for (std::size_t i = 0; i + some.size() <= frames.size(); i += some.size()) {
        std::copy_n(frames.begin() + static_cast<std::ptrdiff_t>(i), some.size(), some.begin());
        spent += cpuSeconds([&] { work(std::span<const core::HapticFrame>(some)); });
    }
    return spent;
}

/// As in a session: 20 frames into the ring, then one drain; the pushes count too.
double recordThroughRing(std::span<const core::HapticFrame> frames, TrialSink& sink,
                         const ChannelTable& table, const std::filesystem::path& ringFolder) {
    const Position position;
    Recorder recorder(table, position, sink, {});
    RingSettings settings;
    settings.folder = ringFolder;
    settings.session = getpid(); // two runs at once do not meet
    auto ring = CrashRing::create(settings);
    if (!ring) {
        std::fprintf(stderr, "%s\n", ring.error().message.c_str());
        std::exit(1);
    }
    FrameDrain drain(**ring, recorder);
    double spent = onWarmFrames(frames, [&](std::span<const core::HapticFrame> some) {
        for (std::size_t i = 0; i < some.size(); ++i) {
            (*ring)->tryPush(some[i]);
            if (i % 20 == 19)
                static_cast<void>(drain.drain(some[i].header.now_ns));
        }
    });
    spent += cpuSeconds([&] { static_cast<void>(drain.finish()); });
    static_cast<void>((*ring)->remove());
    return spent;
}

void benchWriting(const std::filesystem::path& folder, std::span<const core::HapticFrame> frames,
                  const ChannelTable& table) {
    std::vector<double> rows, chunks, encode, hdf5;
    double rowBytes = 0, chunkBytes = 0, payloadBytes = 0;
    const double perSecond = 1e6 / (static_cast<double>(frames.size()) / 1000.0);
    for (int r = 0; r < kRepeats; ++r) {
        removeAll(folder / "rows.db");
        removeAll(folder / "chunks.db");
        {
            SqliteRows peer(folder / "rows.db");
            const double spent = onWarmFrames(frames, [&](std::span<const core::HapticFrame> some) {
                for (const auto& frame : some)
                    peer.append(frame);
            });
            rows.push_back(perSecond * (spent + cpuSeconds([&] { peer.finish(); })));
        }
        rowBytes = static_cast<double>(sizeOf(folder / "rows.db"));
        {
            SqliteChunks ours(folder / "chunks.db", table.encode());
            chunks.push_back(perSecond * recordThroughRing(frames, ours, table, kRingFolder));
            ours.finish();
        }
        chunkBytes = static_cast<double>(sizeOf(folder / "chunks.db"));
        MemoryChunkStore memory(table.encode());
        encode.push_back(perSecond * recordThroughRing(frames, memory, table, kRingFolder));
        payloadBytes = 0;
        for (const Chunk& c : memory.chunks())
            payloadBytes += static_cast<double>(c.payload.size() + 2 * sizeof(Digest));
        if (Hdf5Table::available())
            hdf5.push_back(perSecond * cpuSeconds([&] { Hdf5Table::write(folder / "table.h5", frames); }));
    }
    report("push, drain, encode, sum, hash | rows", "us/s", rows, encode, "goal >= 10");
    report("the same and store in SQLite, 5 commits a second | rows", "us/s", rows, chunks, "");
    report("bytes a minute, chunks with digests | rows file", "MB", {rowBytes * 1e-6}, {payloadBytes * 1e-6},
           "goal >= 18");
    report("bytes a minute, file | rows file", "MB", {rowBytes * 1e-6}, {chunkBytes * 1e-6}, "");
    if (!Hdf5Table::available())
        return void(std::printf("HDF5: not measured\n"));
    const auto hdf5Bytes = static_cast<double>(sizeOf(folder / "table.h5"));
    report("push, drain, encode, sum, hash | HDF5 (doubles, deflate 1)", "us/s", hdf5, encode, "");
    report("bytes a minute, chunks with digests | HDF5", "MB", {hdf5Bytes * 1e-6}, {payloadBytes * 1e-6}, "");
}

double readSecond(RecordingReader& reader, std::uint64_t tick) {
    double sum = 0.0;
    for (std::size_t chunk = tick / 200; chunk < reader.chunkCount() && chunk * 200 < tick + 1000; ++chunk) {
        const auto frames = reader.framesOf(chunk);
        for (const core::HapticFrame& frame : *frames)
            sum += frame.tool[0].tissue[2];
    }
    return sum;
}

void benchReading(const std::filesystem::path& folder, std::size_t frames, const ChannelTable& table) {
    core::Random random(5);
    std::vector<double> rowsOpen, oursOpen, rowsOne, oursOne, rowsSpan, oursSpan, rowsScan, oursScan,
        firstScan, h5Scan, h5Span;
    volatile double sink = 0.0;
    for (int r = 0; r < kRepeats * 5; ++r) {
        const std::uint64_t tick = random.below(frames - 2000);
        std::optional<SqliteRows> rows;
        std::optional<SqliteChunks> chunks;
        std::optional<RecordingReader> reader;
        rowsOpen.push_back(1e6 * cpuSeconds([&] {
                               rows.emplace(folder / "rows.db");
                               sink = rows->readSpan(tick, 1000);
                           }));
        oursOpen.push_back(1e6 * cpuSeconds([&] {
                               chunks.emplace(folder / "chunks.db", table.encode());
                               reader.emplace(*RecordingReader::open(*chunks));
                               sink = readSecond(*reader, tick);
                           }));
        const std::uint64_t other = random.below(frames - 2000);
        rowsSpan.push_back(1e6 * cpuSeconds([&] { sink = rows->readSpan(other, 1000); }));
        oursSpan.push_back(1e6 * cpuSeconds([&] { sink = readSecond(*reader, other); }));
        rowsOne.push_back(1e6 * cpuSeconds([&] { sink = rows->readSpan(other, 1); }));
        oursOne.push_back(
            1e6 * cpuSeconds([&] {
                sink = reader->frameAtTick(other + 5000 < frames ? other + 5000 : 0)->tool[0].tissue[2];
            }));
        if (Hdf5Table::available())
            h5Span.push_back(
                1e6 * cpuSeconds([&] { sink = Hdf5Table::readSpan(folder / "table.h5", other, 1000); }));
        if (r % 5 != 0)
            continue;
        const auto scan = [&] { sink = static_cast<double>(reader->channelCounts(0, "tissue.fz")->back()); };
        rowsScan.push_back(1e3 * cpuSeconds([&] { sink = rows->scanOne(); }));
        firstScan.push_back(1e3 * cpuSeconds(scan));
        oursScan.push_back(1e3 * cpuSeconds(scan));
        if (Hdf5Table::available())
            h5Scan.push_back(1e3 * cpuSeconds([&] { sink = Hdf5Table::scanOne(folder / "table.h5"); }));
    }
    report("open, then seek and read one second | rows", "us", rowsOpen, oursOpen, "");
    report("seek and read one second, all open | rows", "us", rowsSpan, oursSpan, "");
    report("seek one frame, all open | rows by primary key", "us", rowsOne, oursOne, "");
    report("one channel over 10 min, first touch (digests) | rows", "ms", rowsScan, firstScan, "");
    report("one channel over 10 min, digests checked before | rows", "ms", rowsScan, oursScan, "goal >= 25");
    if (Hdf5Table::available()) {
        report("seek and read one second | HDF5", "us", h5Span, oursSpan, "");
        report("one channel over 10 min | HDF5", "ms", h5Scan, oursScan, "");
    }
}

void benchRing(std::span<const core::HapticFrame> frames) {
    constexpr std::size_t kPushes = 4000;
    std::vector<double> locked, ours;
    std::mutex mutex;
    std::vector<core::HapticFrame> queue(kPushes);
    for (int r = 0; r < kRepeats * 5; ++r) {
        RingSettings settings;
        settings.folder = kRingFolder;
        settings.session = getpid();
        auto ring = CrashRing::create(settings);
        locked.push_back(1e9 / kPushes * cpuSeconds([&] {
                             for (std::size_t i = 0; i < kPushes; ++i) {
                                 const std::lock_guard guard(mutex);
                                 queue[i] = frames[i % 200];
                             }
                         }));
        ours.push_back(1e9 / kPushes * cpuSeconds([&] {
                           for (std::size_t i = 0; i < kPushes; ++i)
                               (*ring)->tryPush(frames[i % 200]);
                       }));
        static_cast<void>((*ring)->remove());
    }
    report("push one frame of one tool | mutex and copy of the frame", "ns", locked, ours,
           "goal: ours <= 15 ns");
}
} // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder =
        std::filesystem::path(argc > 1 ? argv[1] : ".") / "chiron-bench-recording";
    std::filesystem::create_directories(folder);
    const auto table = ChannelTable::forTools(tests::HapticTrace::channels(1));
    const auto frames = tests::HapticTrace(11).take(kTenMinutes);
    std::printf("%-58s %10s %10s %-10s %8s\n", "work | peer", "peer", "ours", "unit", "ratio");
    benchRing(frames);
    std::printf("-- a minute, wrenches of three live components (point contact)\n");
    benchWriting(folder, tests::HapticTrace(11, 1, false).take(kMinute), *table);
    std::printf("-- a minute, wrenches of six live components\n");
    benchWriting(folder, std::span(frames).first(kMinute), *table);
    std::printf("-- ten minutes of the latter, read\n");
    removeAll(folder / "rows.db");
    removeAll(folder / "chunks.db");
    {
        SqliteRows rows(folder / "rows.db");
        for (const auto& frame : frames)
            rows.append(frame);
        rows.finish();
        SqliteChunks chunks(folder / "chunks.db", table->encode());
        recordThroughRing(frames, chunks, *table, kRingFolder);
        chunks.finish();
        if (Hdf5Table::available())
            Hdf5Table::write(folder / "table.h5", frames);
    }
    benchReading(folder, frames.size(), *table);
    std::filesystem::remove_all(folder);
    return 0;
}
