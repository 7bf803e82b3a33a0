// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "recording/crash_ring.h"
#include "recording/crc32c.h"
#include "recording/ring_drain.h"
#include "recording/ring_recovery.h"
#include "unit/recording/ring_support.h"

#include <QtTest>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace chiron;
using namespace chiron::recording;
using namespace chiron::tests;

class TestCrashRing : public QObject {
    Q_OBJECT
private slots:
    void crcMatchesThePublishedVector();
    void bothChecksumVariantsAgree();
    void checksumSeesEveryBitAndTheNumber();
    void framesComeOutAsTheyWentIn_data();
    void framesComeOutAsTheyWentIn();
    void wrapsAroundAndCountsDrops();
    void refusesFramesOfOtherTools();
    void badSettingsAreRefused();
    void missingFolderIsAStorageError();
    void damagedSlotIsLeftOutLive();
    void tooLittleRoomRefuses_data();
    void tooLittleRoomRefuses();
    void writerAndDrainRunTogether();

private:
    RingFolder m_rings;
};

void TestCrashRing::crcMatchesThePublishedVector() {
    const std::string_view text = "123456789"; // RFC 3720, B.4 and the usual check value of CRC-32C
    QCOMPARE(crc32c({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}), 0xE3069283u);
    const std::vector<std::uint8_t> zeros(32), ones(32, 0xff);
    QCOMPARE(crc32c(zeros), 0x8A9136AAu);
    QCOMPARE(crc32c(ones), 0x62A8AB43u);
}

void TestCrashRing::bothChecksumVariantsAgree() {
    core::Random random(1);
    for (std::size_t words = 0; words <= 130; ++words) {
        std::vector<std::uint64_t> from(words), fast(words), portable(words);
        for (std::uint64_t& w : from)
            w = random.next();
        const std::uint64_t number = random.next();
        QCOMPARE(copyWithChecksum()(number, fast.data(), from.data(), words),
                 copyWithChecksumPortable(number, portable.data(), from.data(), words));
        QVERIFY(fast == from && portable == from);
    }
}

void TestCrashRing::checksumSeesEveryBitAndTheNumber() {
    core::Random random(2);
    std::array<std::uint64_t, 35> words{}, to{};
    for (std::uint64_t& w : words)
        w = random.next();
    const std::uint32_t before = copyWithChecksum()(7, to.data(), words.data(), words.size());
    for (std::size_t i = 0; i < words.size(); ++i)
        for (int bit = 0; bit < 64; ++bit) {
            words[i] ^= std::uint64_t{1} << bit;
            QVERIFY(copyWithChecksum()(7, to.data(), words.data(), words.size()) != before);
            words[i] ^= std::uint64_t{1} << bit;
        }
    QVERIFY(copyWithChecksum()(8, to.data(), words.data(), words.size()) != before);
}

void TestCrashRing::framesComeOutAsTheyWentIn_data() {
    QTest::addColumn<int>("tools");
    for (int tools = 1; tools <= core::kMaxTools; ++tools)
        QTest::addRow("%d tools", tools) << tools;
}

void TestCrashRing::framesComeOutAsTheyWentIn() {
    QFETCH(int, tools);
    auto ring = CrashRing::create(m_rings.settings(tools));
    QVERIFY2(ring, ring ? "" : ring.error().message.c_str());
    RingDrain drain(**ring);
    core::Random random(static_cast<std::uint64_t>(tools));
    std::vector<core::HapticFrame> in, out(100);
    QCOMPARE(drain.read(out), std::size_t{0});
    for (std::uint64_t i = 0; i < 100; ++i) {
        in.push_back(randomFrame(random, tools, i));
        QVERIFY((*ring)->tryPush(in.back()));
    }
    QCOMPARE(drain.read(std::span(out).first(30)), std::size_t{30});
    QCOMPARE(drain.read(std::span(out).subspan(30)), std::size_t{70});
    for (std::size_t i = 0; i < in.size(); ++i)
        QVERIFY(sameFrame(in[i], out[i]));
}

void TestCrashRing::wrapsAroundAndCountsDrops() {
    auto ring = CrashRing::create(m_rings.settings());
    RingDrain drain(**ring);
    HapticTrace trace(1);
    std::vector<core::HapticFrame> out(5000);
    std::uint64_t expected = 0;
    for (int round = 0; round < 5; ++round) {
        for (int i = 0; i < 4096; ++i) {
            QVERIFY((*ring)->hasRoom());
            QVERIFY((*ring)->tryPush(trace.next()));
        }
        QVERIFY(!(*ring)->hasRoom());
        QVERIFY(!(*ring)->tryPush(trace.next())); // read or not: what is not committed is not overwritten
        QCOMPARE(drain.read(out), std::size_t{4096});
        QVERIFY(!(*ring)->tryPush(trace.next()));
        for (std::size_t i = 0; i < 4096; ++i)
            QCOMPARE(out[i].header.index, expected++);
        expected += 2; // the two that were dropped
        QCOMPARE(drain.dropped(), static_cast<std::uint64_t>(2 * (round + 1)));
        drain.commit(drain.position());
    }
}

void TestCrashRing::refusesFramesOfOtherTools() {
    auto ring = CrashRing::create(m_rings.settings(2));
    core::HapticFrame frame;
    for (const std::uint32_t tools : {0u, 1u, 3u, 4u, 5u, 0xffffffffu}) {
        frame.tools = tools;
        QVERIFY(!(*ring)->tryPush(frame));
    }
    QCOMPARE((*ring)->dropped(), std::uint64_t{6});
}

void TestCrashRing::badSettingsAreRefused() {
    RingSettings s = m_rings.settings();
    s.tools = 0;
    QCOMPARE(CrashRing::create(s).error().code, core::ErrorCode::wrongUse);
    s.tools = core::kMaxTools + 1;
    QCOMPARE(CrashRing::create(s).error().code, core::ErrorCode::wrongUse);
    s.tools = 1;
    for (const std::uint32_t capacity : {0u, 1u, 2048u, 5000u, kMaximumSlots * 2}) {
        s.capacity = capacity;
        QCOMPARE(CrashRing::create(s).error().code, core::ErrorCode::wrongUse);
    }
}

void TestCrashRing::missingFolderIsAStorageError() {
    RingSettings s = m_rings.settings();
    s.folder /= "nowhere";
    const auto refused = CrashRing::create(s);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::storage);
    QVERIFY(refused.error().message.find(s.folder.string()) != std::string::npos);
}

void TestCrashRing::damagedSlotIsLeftOutLive() {
    auto ring = CrashRing::create(m_rings.settings());
    RingDrain drain(**ring);
    HapticTrace trace(1);
    for (int i = 0; i < 10; ++i)
        (*ring)->tryPush(trace.next());
    patch((*ring)->path(), kRingHeaderBytes + 4 * slotBytesFor(1) + sizeof(SlotHeader) + 100, 0x01);
    std::vector<core::HapticFrame> out(20);
    QCOMPARE(drain.read(out), std::size_t{9});
    QCOMPARE(drain.damaged(), std::uint64_t{1});
    QCOMPARE(out[4].header.index, std::uint64_t{5});
}

void TestCrashRing::tooLittleRoomRefuses_data() {
    QTest::addColumn<bool>("fullDisk");
    QTest::newRow("limit on file size") << false;
    QTest::newRow("full file system") << true;
}

void TestCrashRing::tooLittleRoomRefuses() {
    QFETCH(bool, fullDisk);
    const RingSettings s = m_rings.settings();
    const pid_t child = fork();
    if (child == 0) { // 0: refused in words and nothing left; 1: not refused; 2: cannot be tried here
        rlimit limit{100'000, 100'000};
        const bool ready = fullDisk ? unshare(CLONE_NEWNS) == 0 && // the mount is the child's alone
                                          mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                                          mount("none", s.folder.c_str(), "tmpfs", 0, "size=256k") == 0
                                    : setrlimit(RLIMIT_FSIZE, &limit) == 0;
        if (!ready)
            _exit(2);
        const auto ring = CrashRing::create(s);
        const bool empty = std::filesystem::is_empty(s.folder) || !fullDisk;
        const bool gone = listRings(s.folder, s.database).empty() || !fullDisk;
        const bool words = !ring && ring.error().code == core::ErrorCode::storage;
        _exit(words && empty && gone ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    QVERIFY(WIFEXITED(status)); // no SIGBUS, no SIGXFSZ
    if (WEXITSTATUS(status) == 2)
        QSKIP("needs the right to mount a small file system");
    QCOMPARE(WEXITSTATUS(status), 0);
}

void TestCrashRing::writerAndDrainRunTogether() {
    constexpr std::uint64_t kFrames = 60'000;
    auto ring = CrashRing::create(m_rings.settings());
    std::thread writer([&ring] {
        core::HapticFrame frame;
        frame.tools = 1;
        for (std::uint64_t n = 0; n < kFrames; ++n) {
            frame.header.index = n;
            frame.tool[0].tissue.fill(static_cast<double>(n));
            while (!(*ring)->hasRoom())
                std::this_thread::yield();
            (*ring)->tryPush(frame);
        }
    });
    RingDrain drain(**ring);
    std::vector<core::HapticFrame> out(100);
    std::uint64_t next = 0;
    bool ordered = true;
    while (next < kFrames) {
        const std::size_t count = drain.read(out);
        for (std::size_t i = 0; i < count; ++i, ++next)
            ordered = ordered && out[i].header.index == next &&
                      out[i].tool[0].tissue[5] == static_cast<double>(next);
        drain.commit(drain.position());
        if (count == 0)
            std::this_thread::yield();
    }
    writer.join();
    QVERIFY(ordered);
    QCOMPARE(drain.dropped(), std::uint64_t{0});
    QCOMPARE(drain.damaged(), std::uint64_t{0});
}

QTEST_APPLESS_MAIN(TestCrashRing)
#include "test_crash_ring.moc"
