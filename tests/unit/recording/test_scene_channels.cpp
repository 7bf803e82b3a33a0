// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene records beside its tools: quantities by name and resolution, and the books of energy.
#include "recording/chunk_decoder.h"
#include "recording/chunk_encoder.h"
#include "recording/wrench_rounding.h"
#include "support/haptic_trace.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using namespace chiron::recording;

namespace {

const std::vector<core::QuantityDescription> kQuantities{
    {"tension_N", "N", 1e-3}, {"grip_0", "1", 1.0}, {"free_end_x_m", "m", 1e-6}};

ChannelTable tableOf(const SceneChannels& scene, int tools = 2) {
    return *ChannelTable::forTools(tests::HapticTrace::channels(tools), scene);
}

std::vector<core::HapticFrame> framesWithValues() {
    auto frames = tests::HapticTrace(3, 2).take(300);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        auto& header = frames[i].header;
        header.quantities[0] = 0.00123456 * static_cast<double>(i);
        header.quantities[1] = static_cast<double>(i / 100);
        header.quantities[2] = -0.0123456789 + 1e-7 * static_cast<double>(i);
        header.quantities[3] = 5.0; // not named: not recorded
        header.energySupplied_J = 1.23456e-3 * static_cast<double>(i);
        header.energyStored_J = 1.0e-3;
    }
    frames[7].header.quantities[0] = std::numeric_limits<double>::quiet_NaN();
    return frames;
}

std::vector<core::HapticFrame> throughAChunk(const ChannelTable& table,
                                             std::span<const core::HapticFrame> frames) {
    ChunkEncoder encoder(table);
    auto chunk = encoder.encode(0, frames);
    ChunkDecoder decoder(*ChannelTable::decode(table.encode()));
    std::vector<core::HapticFrame> read;
    if (auto done = decoder.decode(*chunk, read); !done)
        qFatal("%s", done.error().message.c_str());
    return read;
}

} // namespace

class TestSceneChannels : public QObject {
    Q_OBJECT
private slots:
    /// A session without quantities has the table it always had, byte for byte; with them they follow behind
    /// it.
    void theyComeAfterEverythingElse() {
        const auto plain = ChannelTable::forTools(tests::HapticTrace::channels(2));
        QVERIFY(plain->encode() == tableOf({}).encode());
        const ChannelTable with = tableOf({kQuantities, true});
        QCOMPARE(with.channels().size(), plain->channels().size() + 5);
        for (std::size_t i = 0; i < plain->channels().size(); ++i)
            QCOMPARE(with.channels()[i].id, plain->channels()[i].id);
        for (std::size_t i = 0; i < kQuantities.size(); ++i) {
            const auto found = with.find(kNoTool, "quantity." + kQuantities[i].id);
            QVERIFY(found);
            const Channel& c = with.channels()[*found];
            QCOMPARE(c.kind, ChannelKind::quantised);
            QCOMPARE(c.unit, kQuantities[i].unit);
            QCOMPARE(c.resolution, kQuantities[i].resolution);
            QCOMPARE(static_cast<std::size_t>(c.slot), i);
        }
        QVERIFY(with.find(kNoTool, "energy.supplied") && with.find(kNoTool, "energy.stored"));
        QVERIFY(!tableOf({kQuantities, false}).find(kNoTool, "energy.supplied"));
        QCOMPARE(with.tools(), 2); // they belong to no tool
    }

    void valuesComeBackOnTheirGrids() {
        const auto frames = framesWithValues();
        const auto read = throughAChunk(tableOf({kQuantities, true}), frames);
        QCOMPARE(read.size(), frames.size());
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const auto& in = frames[i].header;
            const auto& out = read[i].header;
            if (i == 7)
                QVERIFY(std::isnan(out.quantities[0])); // a recording of a fault must be readable too
            else
                QCOMPARE(out.quantities[0], std::nearbyint(in.quantities[0] * 1e3) / 1e3);
            QCOMPARE(out.quantities[1], in.quantities[1]);
            QCOMPARE(out.quantities[2], std::nearbyint(in.quantities[2] * 1e6) / 1e6);
            QCOMPARE(out.quantities[3], 0.0);
            QCOMPARE(out.energySupplied_J, std::nearbyint(in.energySupplied_J * 1e5) / 1e5);
            QCOMPARE(out.energyStored_J, 1e-3);
        }
    }

    /// The rest of the frame is what it is without them.
    void theyLeaveTheRestAlone() {
        const auto frames = framesWithValues();
        auto with = throughAChunk(tableOf({kQuantities, true}), frames);
        const auto without = throughAChunk(tableOf({}), frames);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            with[i].header.quantities = {};
            with[i].header.energySupplied_J = with[i].header.energyStored_J = 0.0;
            QVERIFY(tests::sameFrame(with[i], without[i]));
            QVERIFY(tests::sameFrame(without[i], roundedFrame(frames[i])));
        }
    }

    void whatCannotBeRecordedIsRefused() {
        const auto refused = [](SceneChannels scene) {
            const auto table = ChannelTable::forTools(tests::HapticTrace::channels(1), scene);
            return table ? std::string() : table.error().message;
        };
        SceneChannels many;
        for (std::size_t i = 0; i <= core::kMaxQuantities; ++i)
            many.quantities.push_back({"q" + std::to_string(i), "1", 1.0});
        QVERIFY(refused(many).find("21 quantities") != std::string::npos);
        many.quantities.pop_back();
        QCOMPARE(refused(many), std::string());
        QVERIFY(refused({{{"", "N", 1e-3}}, false}).find("quantity 0") != std::string::npos);
        QVERIFY(refused({{{"a,b", "N", 1e-3}}, false}).find("a,b") != std::string::npos);
        QVERIFY(!refused({{{"a", "N", 1e-3}, {"a", "N", 1e-3}}, false}).empty());
        QVERIFY(!refused({{{"a", "N", 0.0}}, false}).empty());
        QVERIFY(!refused({{{"a", "N", std::numeric_limits<double>::quiet_NaN()}}, false}).empty());
    }
};

QTEST_APPLESS_MAIN(TestSceneChannels)
#include "test_scene_channels.moc"
