// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "recording/channel_table.h"
#include "support/haptic_trace.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using namespace chiron::recording;

class TestChannelTable : public QObject {
    Q_OBJECT
private slots:
    void encodedTableReadsBackTheSame();
    void listsEverythingThatAFrameHolds();
    void aJawWithoutAResolutionCountsSingly();
    void refusesToolsAndAxesOutOfRange();
    void refusesFlawedChannels_data();
    void refusesFlawedChannels();
    void everyTruncationIsAnErrorWithItsPlace();
    void randomDamageNeverCrashes();
};

namespace {
bool sameChannel(const Channel& a, const Channel& b) {
    return a.tool == b.tool && a.id == b.id && a.unit == b.unit && a.resolution == b.resolution &&
           a.frame == b.frame && a.kind == b.kind && a.slot == b.slot && a.reference == b.reference &&
           a.factor == b.factor;
}
} // namespace

void TestChannelTable::encodedTableReadsBackTheSame() {
    for (int tools = 1; tools <= core::kMaxTools; ++tools) {
        const auto made = ChannelTable::forTools(tests::HapticTrace::channels(tools));
        QVERIFY(made);
        const auto read = ChannelTable::decode(made->encode());
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        QCOMPARE(read->tools(), tools);
        QCOMPARE(read->channels().size(), made->channels().size());
        for (std::size_t i = 0; i < made->channels().size(); ++i)
            QVERIFY(sameChannel(made->channels()[i], read->channels()[i]));
    }
}

void TestChannelTable::listsEverythingThatAFrameHolds() {
    const auto table = ChannelTable::forTools(tests::HapticTrace::channels(2));
    QVERIFY(table);
    for (const char* id :
         {"tick", "now", "events", "guards", "trial", "heartbeat_age", "phase", "force_state", "paused",
          "command_0_kind", "command_0_argument", "command_1_kind", "command_1_argument"})
        QVERIFY2(table->find(kNoTool, id), id);
    for (std::uint8_t tool = 0; tool < 2; ++tool) {
        for (const char* id :
             {"axis.x", "axis.roll", "jaw", "buttons", "packet", "status", "device_time", "age"})
            QVERIFY2(table->find(tool, id), id);
        for (const std::string wrench : {"tissue", "commanded", "measured"})
            for (const std::string part : {".fx", ".fy", ".fz", ".tx", ".ty", ".tz"}) {
                const auto found = table->find(tool, wrench + part);
                QVERIFY(found);
                const Channel& c = table->channels()[*found];
                QCOMPARE(c.kind, ChannelKind::quantised);
                QCOMPARE(c.resolution, part[1] == 'f' ? 1e-3 : 1e-5); // data.md: 1 mN and 0.01 mN·m
                QCOMPARE(c.frame, std::string("W"));
            }
    }
    QVERIFY(!table->find(2, "axis.x"));
}

void TestChannelTable::aJawWithoutAResolutionCountsSingly() {
    for (const double resolution : {0.0, 1e-300, 1.5e-4}) {
        auto tools = tests::HapticTrace::channels(1);
        tools[0].jawResolution_rad = resolution;
        const auto table = ChannelTable::forTools(tools);
        QVERIFY2(table, table ? "" : table.error().message.c_str());
        QCOMPARE(table->channels()[*table->find(0, "jaw")].resolution, resolution > 0.0 ? resolution : 1.0);
    }
}

void TestChannelTable::refusesToolsAndAxesOutOfRange() {
    QVERIFY(!ChannelTable::forTools({}));
    auto five = tests::HapticTrace::channels(core::kMaxTools);
    five.push_back(five.front());
    QVERIFY(!ChannelTable::forTools(five));
    auto noAxes = tests::HapticTrace::channels(2);
    noAxes[1].axes.clear();
    const auto refused = ChannelTable::forTools(noAxes);
    QVERIFY(!refused);
    QVERIFY(refused.error().message.find("tool 1") != std::string::npos);
    auto manyAxes = tests::HapticTrace::channels(1);
    manyAxes[0].axes.resize(core::kMaxCoordinates + 1, {"a", "m", 1.0});
    QVERIFY(!ChannelTable::forTools(manyAxes));
    auto badResolution = tests::HapticTrace::channels(1);
    badResolution[0].axes[2].resolution = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!ChannelTable::forTools(badResolution));
}

void TestChannelTable::refusesFlawedChannels_data() {
    QTest::addColumn<bool>("refused");
    for (const char* name : {"twice the same id", "no id", "tool 4", "zero resolution", "reference ahead",
                             "reference of a reference", "long id", "kind 2"})
        QTest::newRow(name) << true;
}

void TestChannelTable::refusesFlawedChannels() {
    const std::string flaw = QTest::currentDataTag();
    Channel plain;
    plain.id = "a";
    Channel other = plain;
    other.id = "b";
    other.reference = 0;
    Channel third = plain;
    third.id = "c";
    QVERIFY(ChannelTable::fromChannels({plain, other, third}));
    if (flaw == "twice the same id")
        third.id = "a";
    else if (flaw == "no id")
        third.id = "";
    else if (flaw == "tool 4")
        third.tool = 4;
    else if (flaw == "zero resolution")
        third.resolution = 0.0;
    else if (flaw == "reference ahead")
        third.reference = 2;
    else if (flaw == "reference of a reference")
        third.reference = 1;
    else if (flaw == "long id")
        third.id = std::string(65, 'x');
    else
        third.kind = static_cast<ChannelKind>(2);
    const auto refused = ChannelTable::fromChannels({plain, other, third});
    QVERIFY(!refused);
    QVERIFY(refused.error().message.find("channel 2") != std::string::npos);
    QVERIFY(refused.error().message.find("expected") != std::string::npos);
}

void TestChannelTable::everyTruncationIsAnErrorWithItsPlace() {
    const auto bytes = ChannelTable::forTools(tests::HapticTrace::channels(1))->encode();
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const auto read = ChannelTable::decode(std::span(bytes).first(length));
        QVERIFY2(!read, std::to_string(length).c_str());
        QVERIFY(read.error().message.find("byte ") != std::string::npos);
        QVERIFY(read.error().message.find("expected") != std::string::npos);
    }
    auto longer = bytes;
    longer.push_back(0);
    QVERIFY(!ChannelTable::decode(longer));
    QVERIFY(!ChannelTable::decode(std::vector<std::uint8_t>(ChannelTable::kMaximumBytes + 1)));
}

void TestChannelTable::randomDamageNeverCrashes() {
    core::Random random = core::Random::stream(1, "channel table damage");
    const auto bytes = ChannelTable::forTools(tests::HapticTrace::channels(2))->encode();
    int refused = 0;
    for (int i = 0; i < 20'000; ++i) {
        auto damaged = bytes;
        for (std::uint64_t flips = 1 + random.below(4); flips > 0; --flips)
            damaged[random.below(damaged.size())] = static_cast<std::uint8_t>(random.next());
        refused += ChannelTable::decode(damaged) ? 0 : 1;
    }
    QVERIFY(refused > 0);
}

QTEST_APPLESS_MAIN(TestChannelTable)
#include "test_channel_table.moc"
