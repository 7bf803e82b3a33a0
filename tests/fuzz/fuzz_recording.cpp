// SPDX-License-Identifier: GPL-3.0-or-later
// 100,000 seeded mutations of real chunks: every one gives frames or an Error, and never more than the caps
// allow.
#include "core/random.h"
#include "recording/chunk_decoder.h"
#include "recording/chunk_encoder.h"
#include "support/haptic_trace.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::recording;

class FuzzRecording : public QObject {
    Q_OBJECT
private slots:
    void mutatedPayloadsGiveAValueOrAnError();
};

namespace {
void mutate(std::vector<std::uint8_t>& bytes, core::Random& random) {
    for (std::uint64_t edits = 1 + random.below(6); edits > 0 && !bytes.empty(); --edits) {
        const auto at = static_cast<std::ptrdiff_t>(random.below(bytes.size()));
        switch (random.below(6)) {
        case 0:
            bytes[static_cast<std::size_t>(at)] ^= static_cast<std::uint8_t>(1u << random.below(8));
            break;
        case 1:
            bytes[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(random.next());
            break;
        case 2:
            bytes[static_cast<std::size_t>(at)] = random.below(2) ? 0xff : 0x40;
            break;
        case 3:
            bytes.erase(bytes.begin() + at);
            break;
        case 4:
            bytes.insert(bytes.begin() + at, static_cast<std::uint8_t>(random.next()));
            break;
        default:
            bytes.resize(static_cast<std::size_t>(at));
            break;
        }
    }
}

std::vector<Chunk> seeds(const ChannelTable& table) {
    ChunkEncoder encoder(table);
    std::vector<Chunk> chunks;
    chunks.push_back(*encoder.encode(0, tests::HapticTrace(1).take(30)));
    chunks.push_back(*encoder.encode(0, tests::HapticTrace(2).take(2)));
    core::Random random(3);
    std::vector<core::HapticFrame> noise, repeating;
    for (std::uint64_t i = 0; i < 20; ++i)
        noise.push_back(tests::randomFrame(random, 1, i));
    for (std::uint64_t i = 0; i < 200; ++i) { // columns that zstd shortens
        repeating.push_back(noise[i % 5]);
        repeating.back().header.index = i;
    }
    chunks.push_back(*encoder.encode(0, noise));
    chunks.push_back(*encoder.encode(0, repeating));
    return chunks;
}
} // namespace

void FuzzRecording::mutatedPayloadsGiveAValueOrAnError() {
    const ChannelTable table = *ChannelTable::forTools(tests::HapticTrace::channels(1));
    const auto chunks = seeds(table);
    ChunkDecoder decoder(table);
    core::Random random = core::Random::stream(1, "fuzz recording");
    std::vector<core::HapticFrame> frames;
    std::vector<std::int64_t> counts;
    int errors = 0;
    for (int i = 0; i < 100'000; ++i) {
        Chunk chunk = chunks[random.below(chunks.size())];
        mutate(chunk.payload, random);
        if (random.below(50) == 0)
            chunk.frames = static_cast<std::uint32_t>(random.next());
        frames.clear();
        counts.clear();
        const auto decoded =
            i % 4 == 0 ? decoder.decode(chunk, frames)
                       : decoder.decodeChannel(chunk, random.below(table.channels().size()), counts);
        QVERIFY(frames.size() <= kMaximumFramesPerChunk && counts.size() <= kMaximumFramesPerChunk);
        if (decoded)
            continue;
        ++errors;
        QVERIFY(frames.empty() && counts.empty());
        QVERIFY(decoded.error().code == core::ErrorCode::badInput);
    }
    qInfo("%d of 100000 refused", errors);
    QVERIFY(errors > 10'000);
}

QTEST_APPLESS_MAIN(FuzzRecording)
#include "fuzz_recording.moc"
