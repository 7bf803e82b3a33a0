// SPDX-License-Identifier: GPL-3.0-or-later
// The format of recordings and of the crash ring to the byte, what is summed up and hashed of made frames,
// and the words in which what does not fit is refused, with its place. Against what was looked at and kept:
// files of today are read for years. A change that is meant is kept anew, and its difference is read in
// review: CHIRON_STORE_OUTLINES=1 ctest --test-dir build/release -R "^test_kept_recordings$"
#include "recording/channel_table.h"
#include "recording/chunk_decoder.h"
#include "recording/chunk_encoder.h"
#include "recording/digest.h"
#include "recording/ring_recovery.h"
#include "recording/wrench_rounding.h"
#include "support/kept_numbers.h"
#include "unit/recording/recorder_support.h"
#include "unit/recording/ring_support.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using namespace chiron::recording;
using namespace chiron::tests;

namespace {

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

/// Frames of numbers that every processor makes alike.
core::HapticFrame madeFrame(std::uint64_t n, std::uint32_t tools) {
    core::HapticFrame frame;
    frame.tools = tools;
    frame.header.index = 100 + n + (n > 40 ? 3 : 0);
    frame.header.now_ns = static_cast<std::int64_t>(5'000'000'000 + n * 1'000'000 + n * n % 777);
    frame.header.events = n % 31 == 0 ? 0x11U : 0U;
    frame.header.guards = n % 17 == 0 ? 0x2001U : 0U;
    frame.header.trial = static_cast<std::uint16_t>(n / 50);
    frame.header.heartbeatAge_ms = static_cast<std::uint16_t>(n % 16);
    frame.header.phase = core::TrialPhase::running;
    frame.header.force = n < 5 ? core::ForceState::ramping : core::ForceState::on;
    frame.header.paused = n >= 60 && n < 70 ? 1 : 0;
    frame.header.commands[0] = {n == 60 ? core::CommandKind::pause : core::CommandKind::none,
                                static_cast<std::uint16_t>(n == 60 ? 7 : 0)};
    frame.header.energySupplied_J = static_cast<double>(n) / 1024.0;
    frame.header.energyStored_J = static_cast<double>(n % 8) / 2048.0;
    frame.header.quantities[0] = static_cast<double>(n % 5);
    frame.header.quantities[1] = n % 3 == 0 ? -0.125 * static_cast<double>(n) : 0.0;
    for (std::uint32_t t = 0; t < tools; ++t) {
        core::ToolFrame& tool = frame.tool[t];
        for (std::size_t k = 0; k < core::kMaxCoordinates; ++k)
            tool.counts[k] = static_cast<std::int32_t>(n * (k + 1) % 97) - static_cast<std::int32_t>(20 * t);
        tool.jawCounts = static_cast<std::int32_t>(n / 4);
        tool.buttons = n % 40 < 5 ? core::kButtonMark : 0U;
        tool.packet = static_cast<std::uint32_t>(1000 + n);
        tool.status = n % 23 == 7 ? core::sample_status::kRefused : core::sample_status::kHomed;
        tool.deviceTime_us = 77'000'000 + 11'000 * n;
        tool.age_us = static_cast<std::uint32_t>(300 + n * n % 50);
        for (std::size_t i = 0; i < 6; ++i) {
            tool.tissue[i] = n % 10 < 7 ? static_cast<double>((n + 3 * i) % 64) / 32.0 : 0.0;
            tool.commanded[i] = n % 4 == 0 ? tool.tissue[i] : 0.5 * tool.tissue[i];
            tool.measured[i] = tool.commanded[i] + 1.0 / 64.0;
        }
        tool.display = {static_cast<double>(n % 32) / 16.0, 0.25, -0.125};
    }
    return frame;
}

std::vector<core::HapticFrame> madeFrames(std::size_t count, std::uint32_t tools) {
    std::vector<core::HapticFrame> frames;
    for (std::uint64_t n = 0; n < count; ++n)
        frames.push_back(madeFrame(n, tools));
    return frames;
}

SceneChannels madeScene() {
    SceneChannels scene;
    scene.quantities = {{"place", "1", 1.0}, {"depth_m", "m", 1e-6}};
    scene.energy = true;
    return scene;
}

/// The same lines only once, with from where on each holds.
class Runs {
public:
    void add(std::size_t at, const QString& words) {
        if (words != m_before)
            lines.add(QStringLiteral("from %1: %2").arg(at).arg(words));
        m_before = words;
    }
    NumberLines lines;

private:
    QString m_before;
};

/// Without the places, which change with every byte.
QString withoutPlace(const std::string& message) {
    QString words = text(message);
    static const QRegularExpression place(QStringLiteral("byte \\d+"));
    return words.replace(place, QStringLiteral("byte N"));
}

} // namespace

class TestKeptRecordings : public QObject {
    Q_OBJECT
private slots:
    void tables();
    void tablesThatAreRefused();
    void chunksThatAreRefused();
    void hashesAndSums();
    void rounding();
    void rings();
    void everythingKeptIsSeen() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const QString& name, const NumberLines& lines) {
        const QString differs = m_kept.differs(name, lines.lines());
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/recording/kept_recordings.txt"),
                           &tests::sameNumbers};
};

void TestKeptRecordings::tables() {
    NumberLines lines;
    for (const int tools : {1, 2}) {
        const auto table = ChannelTable::forTools(HapticTrace::channels(tools), madeScene());
        QVERIFY(table);
        for (const Channel& c : table->channels())
            lines.add(QStringLiteral("%1 %2 [%3] in \"%4\", kind %5, slot %6, reference %7, factor %8")
                          .arg(c.tool)
                          .arg(text(c.id), text(c.unit), text(c.frame))
                          .arg(static_cast<int>(c.kind))
                          .arg(c.slot)
                          .arg(c.reference)
                          .arg(c.factor),
                      {c.resolution});
        const std::vector<std::uint8_t> bytes = table->encode();
        for (std::size_t at = 0; at < bytes.size(); at += 64)
            lines.add(QString::fromLatin1(
                QByteArray(reinterpret_cast<const char*>(bytes.data()) + at,
                           static_cast<qsizetype>(std::min<std::size_t>(64, bytes.size() - at)))
                    .toHex(' ')));
    }
    hold(QStringLiteral("tables"), lines);
}

void TestKeptRecordings::tablesThatAreRefused() {
    NumberLines words;
    const auto make = [&](const char* name, const std::vector<ToolChannels>& tools,
                          const SceneChannels& scene) {
        const auto table = ChannelTable::forTools(tools, scene);
        words.add(QStringLiteral("%1: %2").arg(QLatin1String(name), table ? QStringLiteral("taken")
                                                                          : text(table.error().message)));
    };
    std::vector<ToolChannels> tools = HapticTrace::channels(1);
    make("no tool", {}, {});
    make("four tools", HapticTrace::channels(4), {});
    make("five tools", HapticTrace::channels(5), {});
    tools[0].axes.resize(8, {"a", "m", 1.0});
    for (std::size_t i = 4; i < 8; ++i)
        tools[0].axes[i].id += std::to_string(i);
    make("eight axes", tools, {});
    tools[0].axes.push_back({"b", "m", 1.0});
    make("nine axes", tools, {});
    tools[0].axes.clear();
    make("no axis", tools, {});
    SceneChannels many;
    for (int i = 0; i < 20; ++i)
        many.quantities.push_back({"q_" + std::to_string(i), "1", 1.0});
    make("twenty quantities", HapticTrace::channels(1), many);
    many.quantities.push_back({"q_20", "1", 1.0});
    make("twenty-one quantities", HapticTrace::channels(1), many);
    for (const char* id : {"", "azAZ09_", "a b", "a-", "{", "`", "@", "[", "/", ":"}) {
        SceneChannels one;
        one.quantities = {{id, "1", 1.0}};
        make(id, HapticTrace::channels(1), one);
    }
    const auto list = [&](const char* name, std::size_t count, auto change) {
        std::vector<Channel> channels(count);
        for (std::size_t i = 0; i < count; ++i)
            channels[i].id = "c" + std::to_string(i);
        change(channels);
        const auto table = ChannelTable::fromChannels(channels);
        words.add(QStringLiteral("%1: %2").arg(QLatin1String(name),
                                               table ? QStringLiteral("taken, tools %1").arg(table->tools())
                                                     : text(table.error().message)));
    };
    list("none", 0, [](auto&) {});
    list("512", 512, [](auto&) {});
    list("513", 513, [](auto&) {});
    list("too long", 400, [](auto& c) {
        for (auto& channel : c) {
            channel.id += std::string(58, 'x');
            channel.unit = channel.frame = std::string(64, 'y');
        }
    });
    for (const int tool : {3, 4, 254, 255})
        list("tool", 3, [tool](auto& c) { c[1].tool = static_cast<std::uint8_t>(tool); });
    for (const std::size_t length : {std::size_t{0}, std::size_t{64}, std::size_t{65}}) {
        list("id", 3, [length](auto& c) { c[2].id = std::string(length, 'i'); });
        list("unit", 3, [length](auto& c) { c[2].unit = std::string(length, 'i'); });
        list("frame", 3, [length](auto& c) { c[2].frame = std::string(length, 'i'); });
    }
    for (const double resolution : {0.0, -1.0, 1e-300, std::nan(""), std::numeric_limits<double>::infinity()})
        list("resolution", 3, [resolution](auto& c) { c[0].resolution = resolution; });
    for (const int kind : {0, 1, 2})
        list("kind", 3, [kind](auto& c) { c[0].kind = static_cast<ChannelKind>(kind); });
    for (const int reference : {-2, -1, 0, 1, 2, 3})
        list("reference", 4, [reference](auto& c) { c[2].reference = reference; });
    list("reference of one that has one", 4, [](auto& c) {
        c[1].reference = 0;
        c[3].reference = 1;
    });
    list("the same id", 3, [](auto& c) { c[2].id = "c0"; });
    list("the same id of another tool", 3, [](auto& c) {
        c[2].id = "c0";
        c[2].tool = 2;
    });
    hold(QStringLiteral("tables that are refused"), words);

    const std::vector<std::uint8_t> bytes =
        ChannelTable::forTools(HapticTrace::channels(1), madeScene())->encode();
    Runs cut, changed;
    for (std::size_t length = 0; length <= bytes.size(); ++length) {
        const auto table = ChannelTable::decode(std::span(bytes).first(length));
        cut.add(length, table ? QStringLiteral("taken") : text(table.error().message));
    }
    hold(QStringLiteral("tables cut off"), cut.lines);
    for (std::size_t at = 0; at < std::min<std::size_t>(bytes.size(), 700); ++at) {
        std::vector<std::uint8_t> other = bytes;
        other[at] = static_cast<std::uint8_t>(other[at] + 0x81);
        const auto table = ChannelTable::decode(other);
        changed.add(at, table ? QStringLiteral("taken") : text(table.error().message));
    }
    std::vector<std::uint8_t> more = bytes;
    more.push_back(0);
    changed.add(bytes.size(), text(ChannelTable::decode(more).error().message));
    more.resize(64 * 1024);
    changed.add(more.size(), text(ChannelTable::decode(more).error().message));
    more.push_back(0);
    changed.add(more.size(), text(ChannelTable::decode(more).error().message));
    hold(QStringLiteral("tables changed"), changed.lines);
}

void TestKeptRecordings::chunksThatAreRefused() {
    const auto table = *ChannelTable::forTools(HapticTrace::channels(1), madeScene());
    ChunkEncoder encoder(table);
    NumberLines words;
    const auto frames = madeFrames(6, 1); // so few that no column is worth compressing
    auto chunk = encoder.encode(4, frames);
    QVERIFY(chunk);
    const auto say = [&](const char* name, const Chunk& changed) {
        ChunkDecoder decoder(table);
        std::vector<core::HapticFrame> read;
        const auto decoded = decoder.decode(changed, read);
        words.add(
            QStringLiteral("%1: %2, %3 frames")
                .arg(QLatin1String(name), decoded ? QStringLiteral("taken") : text(decoded.error().message))
                .arg(read.size()));
    };
    say("as it is", *chunk);
    Chunk other = *chunk;
    other.frames = 0;
    say("no frames", other);
    other.frames = 7;
    say("a frame more", other);
    other.frames = 2'000'000'000;
    say("very many frames", other);
    other = *chunk;
    other.firstTick += 1;
    say("another tick", other);
    other = *chunk;
    other.payload.push_back(0);
    say("a byte more", other);
    other.payload.clear();
    say("empty", other);
    other = *chunk;
    other.payload[0] ^= 1;
    say("another version", other);
    ChunkDecoder decoder(table);
    const auto missing = decoder.decodeTick(*chunk, 99);
    words.add(missing ? QString() : text(missing.error().message));
    const auto there = decoder.decodeTick(*chunk, 103);
    QVERIFY(there && there->header.index == 103);
    const auto none = encoder.encode(1, {});
    words.add(none ? QString() : text(none.error().message));
    const auto two = madeFrames(3, 2);
    const auto others = encoder.encode(1, two);
    words.add(others ? QString() : text(others.error().message));
    hold(QStringLiteral("chunks"), words);

    Runs cut;
    for (std::size_t length = 0; length <= chunk->payload.size(); ++length) {
        other = *chunk;
        other.payload.resize(length);
        std::vector<core::HapticFrame> read;
        const auto decoded = decoder.decode(other, read);
        cut.add(length, decoded ? QStringLiteral("taken") : withoutPlace(decoded.error().message));
    }
    hold(QStringLiteral("chunks cut off"), cut.lines);
}

void TestKeptRecordings::hashesAndSums() {
    NumberLines lines;
    for (const std::uint32_t tools : {1U, 2U, 4U}) {
        const auto frames = madeFrames(130, tools);
        for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{7}, std::size_t{130}})
            lines.add(QStringLiteral("%1 tools, %2 frames: %3")
                          .arg(tools)
                          .arg(count)
                          .arg(text(toHex(forceHashOf(std::span(frames).first(count))))));
        const Position position;
        SecondSummaries summaries(position, 1.5);
        std::vector<SecondSummary> done;
        for (const core::HapticFrame& frame : frames)
            summaries.add(frame, done);
        lines.add(QStringLiteral("%1 before the end").arg(done.size()));
        summaries.finish(done);
        for (const SecondSummary& s : done)
            lines.add(QStringLiteral("second"),
                      {static_cast<double>(s.second), static_cast<double>(s.tool),
                       static_cast<double>(s.frames), s.pathLength_m, s.maximumForce_N, s.meanForce_N,
                       s.impulse_Ns, s.timeOverLimit_s, static_cast<double>(s.events)});
    }
    Chunk chunk;
    chunk.sequence = 3;
    chunk.firstTick = 70'000;
    chunk.frames = 9;
    chunk.payload = {1, 2, 3, 250};
    chunk.forceHash[5] = 77;
    lines.add(text(toHex(payloadDigestOf(chunk))));
    hold(QStringLiteral("hashes and sums"), lines);
}

void TestKeptRecordings::rounding() {
    NumberLines lines;
    for (const double resolution : {1e-3, 1e-5, 2.5e-5, 0.3, 1.0, 1.0 / 3.0, 1e-9})
        lines.add(QStringLiteral("steps"), {resolution, stepsPerUnit(resolution)});
    const double steps = stepsPerUnit(1e-3);
    for (const double value : {0.0, 0.0005, 0.0015, -0.0005, -0.0025, 1.2345, 1073741.8239, 1073741.824,
                               1073741.8246, -1073741.8246, 1e12, -1e300})
        lines.add(QStringLiteral("value"), {value, static_cast<double>(quantise(value, steps)),
                                            dequantise(quantise(value, steps), steps)});
    QCOMPARE(quantise(std::nan(""), steps), kNaNQuantum);
    QCOMPARE(quantise(std::numeric_limits<double>::infinity(), steps), kInfinityQuantum);
    QCOMPARE(quantise(-std::numeric_limits<double>::infinity(), steps), -kInfinityQuantum);
    QVERIFY(std::isnan(dequantise(kNaNQuantum, steps)) && std::isnan(dequantise(kNaNQuantum + 1, steps)) &&
            std::isnan(dequantise(-kNaNQuantum, steps)));
    QVERIFY(dequantise(kInfinityQuantum, steps) == std::numeric_limits<double>::infinity() &&
            dequantise(-kInfinityQuantum, steps) == -std::numeric_limits<double>::infinity());
    core::HapticFrame frame = madeFrame(13, 2);
    frame.header.reserved = 5;
    frame.tool[0].reserved = 6;
    for (core::ToolFrame& tool : frame.tool) {
        tool.tissue = {0.00051, -0.00149, 2.0006, 0.0000051, -0.0000149, 0.1};
        tool.commanded = {1.00051, -1.00149, 3.0006, 0.1000051, -0.2000149, 0.3};
        tool.measured = {2.00051, -2.00149, 4.0006, 0.3000051, -0.4000149, 0.5};
        tool.display = {0.12345, 0.1234567, -0.7654321};
        tool.buttons = 3;
    }
    const core::HapticFrame rounded = roundedFrame(frame);
    for (const core::ToolFrame& tool : rounded.tool) {
        lines.add(QStringLiteral("tissue"), tool.tissue);
        lines.add(QStringLiteral("commanded"), tool.commanded);
        lines.add(QStringLiteral("measured"), tool.measured);
        lines.add(QStringLiteral("display"), tool.display);
        lines.add(QStringLiteral("else"),
                  {static_cast<double>(tool.buttons), static_cast<double>(tool.reserved),
                   static_cast<double>(tool.packet)});
    }
    lines.add(QStringLiteral("header"),
              {static_cast<double>(rounded.header.index), static_cast<double>(rounded.header.reserved),
               rounded.header.energySupplied_J, rounded.header.energyStored_J, rounded.header.quantities[0]});
    hold(QStringLiteral("rounding"), lines);
}

void TestKeptRecordings::rings() {
    NumberLines lines;
    RingFolder rings;
    const auto make = [&](const char* name, int tools, std::uint32_t capacity) {
        RingSettings settings = rings.settings(tools);
        settings.capacity = capacity;
        const auto ring = RingFile::create(settings);
        lines.add(QStringLiteral("%1: %2").arg(
            QLatin1String(name),
            ring ? QStringLiteral("taken, %1 slots of %2 tools").arg(ring->capacity()).arg(ring->tools())
                 : text(ring.error().message)));
    };
    make("no tool", 0, 4096);
    make("four tools", 4, 4096);
    make("five tools", 5, 4096);
    make("small", 1, 2048);
    make("large", 1, 65536);
    make("larger", 1, 131072);
    make("no power of two", 1, 5000);
    for (const std::uint32_t tools : {1U, 2U, 3U, 4U})
        lines.add(QStringLiteral("bytes"),
                  {static_cast<double>(usedFrameBytes(tools)), static_cast<double>(slotBytesFor(tools))});
    lines.add(text(ringFilePrefix(rings.settings().database)));
    RingHeader header;
    header.tools = 2;
    header.capacity = 4096;
    header.slotBytes = 704;
    header.session = 77;
    header.pid = 4711;
    header.database = {1, 2, 3};
    header.bootId[0] = 'b';
    lines.add(QStringLiteral("checksum %1, offsets %2 %3 %4")
                  .arg(identityChecksum(header))
                  .arg(offsetof(RingHeader, committed))
                  .arg(offsetof(RingHeader, dropped))
                  .arg(sizeof(RingHeader)));
    header.committed = header.dropped = 99; // not of its identity
    lines.add(QStringLiteral("checksum %1").arg(identityChecksum(header)));

    // A ring that is otherwise sound, with another number in its header and the checksum that fits.
    const auto spoiled = [&](const char* name, auto change) {
        const auto path = leaveBehind(rings.settings(), 5, 2);
        RingHeader h;
        {
            std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
            file.read(reinterpret_cast<char*>(&h), sizeof h);
            change(h);
            h.checksum = identityChecksum(h);
            file.seekp(0);
            file.write(reinterpret_cast<const char*>(&h), sizeof h);
        }
        const auto ring = recoverRing(path);
        QString said =
            ring ? QStringLiteral("taken, %1 frames").arg(ring->frames().size()) : text(ring.error().message);
        lines.add(QStringLiteral("%1: %2").arg(QLatin1String(name),
                                               said.replace(text(path.string()), QStringLiteral("RING"))));
    };
    spoiled("as it is", [](RingHeader&) {});
    spoiled("another mark", [](RingHeader& h) { h.magic += 1; });
    spoiled("another version", [](RingHeader& h) { h.version = 2; });
    spoiled("another layout", [](RingHeader& h) { h.frameLayout = 3; });
    spoiled("no tool", [](RingHeader& h) { h.tools = 0; });
    spoiled("five tools", [](RingHeader& h) { h.tools = 5; });
    spoiled("more tools", [](RingHeader& h) { h.tools = 2; });
    spoiled("small", [](RingHeader& h) { h.capacity = 2048; });
    spoiled("larger", [](RingHeader& h) { h.capacity = 131072; });
    spoiled("no power of two", [](RingHeader& h) { h.capacity = 5000; });
    spoiled("twice as long", [](RingHeader& h) { h.capacity = 8192; });
    spoiled("other slots", [](RingHeader& h) { h.slotBytes += 64; });
    spoiled("all committed", [](RingHeader& h) { h.committed = 5; });
    hold(QStringLiteral("rings"), lines);
}

QTEST_APPLESS_MAIN(TestKeptRecordings)
#include "test_kept_recordings.moc"
