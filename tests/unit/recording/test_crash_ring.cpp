// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "recording/crash_ring.h"
#include "recording/crc32c.h"
#include "recording/ring_drain.h"
#include "recording/ring_recovery.h"
#include "support/haptic_trace.h"

#include <QTemporaryDir>
#include <QtTest>
#include <atomic>
#include <csignal>
#include <fstream>
#include <sched.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace chiron;
using namespace chiron::recording;

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
    void anOlderRingIsNotOverwritten();
    void aLivingRingIsNotRecovered();
    void recoversWhatWasNotCommitted();
    void tornSlotEndsTheRecovery_data();
    void tornSlotEndsTheRecovery();
    void damagedHeadersAreRefused();
    void damagedSlotIsLeftOutLive();
    void killedWriterLosesAtMostOneFrame();
    void killedWriterWithADrainToo();
    void tooLittleRoomRefuses_data();
    void tooLittleRoomRefuses();
    void listsAndRemovesRings();
    void writerAndDrainRunTogether();

private:
    QTemporaryDir m_folder;
    std::int64_t m_session = 0;
    RingSettings settings(int tools = 1) {
        RingSettings s;
        s.folder = m_folder.path().toStdString();
        s.database = {0xde, 0xad, 0xbe, 0xef, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
        s.session = ++m_session;
        s.tools = tools;
        return s;
    }
    void killAtRandomMoments(std::uint64_t commitEvery);
};

namespace {
void patch(const std::filesystem::path& path, std::size_t offset, std::uint8_t flip) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(static_cast<std::streamoff>(offset));
    const auto byte = static_cast<std::uint8_t>(file.get());
    file.seekp(static_cast<std::streamoff>(offset));
    file.put(static_cast<char>(byte ^ flip));
}

std::filesystem::path leaveBehind(const RingSettings& settings, std::size_t frames, std::uint64_t committed) {
    auto ring = CrashRing::create(settings);
    tests::HapticTrace trace(1, settings.tools);
    RingDrain drain(**ring);
    drain.commit(committed);
    for (std::size_t i = 0; i < frames; ++i)
        (*ring)->tryPush(trace.next());
    return (*ring)->path();
}
} // namespace

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
    auto ring = CrashRing::create(settings(tools));
    QVERIFY2(ring, ring ? "" : ring.error().message.c_str());
    RingDrain drain(**ring);
    core::Random random(static_cast<std::uint64_t>(tools));
    std::vector<core::HapticFrame> in, out(100);
    QCOMPARE(drain.read(out), std::size_t{0});
    for (std::uint64_t i = 0; i < 100; ++i) {
        in.push_back(tests::randomFrame(random, tools, i));
        QVERIFY((*ring)->tryPush(in.back()));
    }
    QCOMPARE(drain.read(std::span(out).first(30)), std::size_t{30});
    QCOMPARE(drain.read(std::span(out).subspan(30)), std::size_t{70});
    for (std::size_t i = 0; i < in.size(); ++i)
        QVERIFY(tests::sameFrame(in[i], out[i]));
}

void TestCrashRing::wrapsAroundAndCountsDrops() {
    auto ring = CrashRing::create(settings());
    RingDrain drain(**ring);
    tests::HapticTrace trace(1);
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
    auto ring = CrashRing::create(settings(2));
    core::HapticFrame frame;
    for (const std::uint32_t tools : {0u, 1u, 3u, 4u, 5u, 0xffffffffu}) {
        frame.tools = tools;
        QVERIFY(!(*ring)->tryPush(frame));
    }
    QCOMPARE((*ring)->dropped(), std::uint64_t{6});
}

void TestCrashRing::badSettingsAreRefused() {
    RingSettings s = settings();
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
    RingSettings s = settings();
    s.folder /= "nowhere";
    const auto refused = CrashRing::create(s);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::storage);
    QVERIFY(refused.error().message.find(s.folder.string()) != std::string::npos);
}

void TestCrashRing::anOlderRingIsNotOverwritten() {
    const RingSettings s = settings();
    const auto path = leaveBehind(s, 10, 0);
    QCOMPARE(CrashRing::create(s).error().code, core::ErrorCode::storage);
    QCOMPARE(recoverRing(path)->frames().size(), std::size_t{10});
}

void TestCrashRing::aLivingRingIsNotRecovered() {
    auto ring = CrashRing::create(settings());
    const auto path = (*ring)->path();
    QCOMPARE(recoverRing(path).error().code, core::ErrorCode::locked);
    ring->reset();
    auto first = recoverRing(path);
    QVERIFY(first);
    QCOMPARE(recoverRing(path).error().code, core::ErrorCode::locked); // one recovery at a time
    QVERIFY(first->remove());
    first = core::fail(core::ErrorCode::notFound, "");
    QCOMPARE(recoverRing(path).error().code, core::ErrorCode::notFound);
}

void TestCrashRing::recoversWhatWasNotCommitted() {
    const RingSettings s = settings(2);
    const auto path = leaveBehind(s, 300, 120);
    const auto ring = recoverRing(path);
    QVERIFY2(ring, ring ? "" : ring.error().message.c_str());
    QVERIFY(ring->database() == s.database);
    QCOMPARE(ring->session(), s.session);
    QCOMPARE(ring->pid(), std::int64_t{getpid()});
    QVERIFY(ring->sameBoot());
    QCOMPARE(ring->tools(), 2);
    QCOMPARE(ring->committed(), std::uint64_t{120});
    QCOMPARE(ring->frames().size(), std::size_t{180});
    auto expected = tests::HapticTrace(1, 2).take(300);
    for (std::size_t i = 0; i < 180; ++i)
        QVERIFY(tests::sameFrame(ring->frames()[i], expected[120 + i]));
}

void TestCrashRing::tornSlotEndsTheRecovery_data() {
    QTest::addColumn<int>("offset");
    QTest::newRow("number") << 0;
    QTest::newRow("checksum") << 8;
    QTest::newRow("layout and tools") << 20;
    QTest::newRow("first tick byte") << static_cast<int>(sizeof(SlotHeader) + 8);
    QTest::newRow("last used byte") << static_cast<int>(sizeof(SlotHeader) + usedFrameBytes(1) - 1);
}

void TestCrashRing::tornSlotEndsTheRecovery() {
    QFETCH(int, offset);
    const auto path = leaveBehind(settings(), 50, 0);
    patch(path, kRingHeaderBytes + 40 * slotBytesFor(1) + static_cast<std::size_t>(offset), 0x10);
    const auto ring = recoverRing(path);
    QVERIFY(ring);
    QCOMPARE(ring->frames().size(), std::size_t{40});
}

void TestCrashRing::damagedHeadersAreRefused() {
    const auto path = leaveBehind(settings(), 5, 0);
    const std::size_t identity = offsetof(RingHeader, committed);
    for (std::size_t at = 0; at < identity; ++at) {
        patch(path, at, 0x04);
        const auto refused = recoverRing(path);
        QVERIFY2(!refused, std::to_string(at).c_str());
        QCOMPARE(refused.error().code, core::ErrorCode::badInput);
        QVERIFY(refused.error().message.find("byte ") != std::string::npos);
        patch(path, at, 0x04);
    }
    QVERIFY(recoverRing(path));
    for (const std::uintmax_t size : {std::uintmax_t{0}, std::uintmax_t{100}, std::uintmax_t{5000}}) {
        std::filesystem::resize_file(path, size);
        QCOMPARE(recoverRing(path).error().code, core::ErrorCode::badInput);
    }
    QCOMPARE(recoverRing(m_folder.path().toStdString()).error().code, core::ErrorCode::storage); // a folder
}

void TestCrashRing::damagedSlotIsLeftOutLive() {
    auto ring = CrashRing::create(settings());
    RingDrain drain(**ring);
    tests::HapticTrace trace(1);
    for (int i = 0; i < 10; ++i)
        (*ring)->tryPush(trace.next());
    patch((*ring)->path(), kRingHeaderBytes + 4 * slotBytesFor(1) + sizeof(SlotHeader) + 100, 0x01);
    std::vector<core::HapticFrame> out(20);
    QCOMPARE(drain.read(out), std::size_t{9});
    QCOMPARE(drain.damaged(), std::uint64_t{1});
    QCOMPARE(out[4].header.index, std::uint64_t{5});
}

// A child pushes frames and counts them in shared memory; it is killed once the count passes a random number.
void TestCrashRing::killAtRandomMoments(std::uint64_t commitEvery) {
    void* memory = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    QVERIFY(memory != MAP_FAILED);
    auto& begun = *new (memory) std::atomic<std::uint64_t>(0);
    core::Random random = core::Random::stream(commitEvery, "kill moments");
    for (int round = 0; round < 12; ++round) {
        begun = 0;
        const RingSettings s = settings();
        const std::uint64_t until = 1 + random.below(3000);
        const pid_t child = fork();
        if (child == 0) {
            auto ring = CrashRing::create(s);
            if (!ring)
                _exit(1);
            RingDrain drain(**ring);
            for (std::uint64_t n = 1;; ++n) {
                core::HapticFrame frame;
                frame.tools = 1;
                frame.header.index = n - 1;
                frame.tool[0].tissue[2] = static_cast<double>(n);
                begun.store(n);
                while (!(*ring)->hasRoom())
                    ; // the parent kills soon
                (*ring)->tryPush(frame);
                if (n % commitEvery == 0)
                    drain.commit(n);
            }
        }
        int status = 0;
        while (begun.load() < until && waitpid(child, &status, WNOHANG) == 0)
            ;
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
        const std::uint64_t pushes = begun.load();
        const auto ring = recoverRing(s.folder / (ringFilePrefix(s.database) + std::to_string(s.session) + kRingSuffix));
        QVERIFY2(ring, ring ? "" : ring.error().message.c_str());
        const std::uint64_t kept = ring->committed() + ring->frames().size();
        QVERIFY2(kept <= pushes && kept + 1 >= pushes, qPrintable(QString("%1 of %2").arg(kept).arg(pushes)));
        for (std::size_t i = 0; i < ring->frames().size(); ++i) {
            QCOMPARE(ring->frames()[i].header.index, ring->committed() + i);
            QCOMPARE(ring->frames()[i].tool[0].tissue[2], static_cast<double>(ring->committed() + i + 1));
        }
    }
    munmap(memory, 4096);
}

void TestCrashRing::killedWriterLosesAtMostOneFrame() { killAtRandomMoments(1'000'000'000); }
void TestCrashRing::killedWriterWithADrainToo() { killAtRandomMoments(7); }

void TestCrashRing::tooLittleRoomRefuses_data() {
    QTest::addColumn<bool>("fullDisk");
    QTest::newRow("limit on file size") << false;
    QTest::newRow("full file system") << true;
}

void TestCrashRing::tooLittleRoomRefuses() {
    QFETCH(bool, fullDisk);
    const RingSettings s = settings();
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

void TestCrashRing::listsAndRemovesRings() {
    RingSettings s = settings();
    s.database[0] = 1;
    QVERIFY(listRings(s.folder, s.database).empty());
    const auto path = leaveBehind(s, 1, 0);
    QCOMPARE(listRings(s.folder, s.database), std::vector<std::filesystem::path>{path});
    RingSettings other = s;
    other.database[0] = 2;
    QVERIFY(listRings(s.folder, other.database).empty());
    QVERIFY(listRings(s.folder / "nowhere", s.database).empty());
    const auto part = s.folder / (ringFilePrefix(s.database) + "99" + kUnfinishedRingSuffix);
    std::ofstream(part) << "half made";
    QCOMPARE(listRings(s.folder, s.database).size(), std::size_t{1});
    QCOMPARE(removeUnfinishedRings(s.folder, s.database), 1);
    QVERIFY(!std::filesystem::exists(part));
    QVERIFY(recoverRing(path)->remove());
    QVERIFY(listRings(s.folder, s.database).empty());
    auto live = CrashRing::create(settings());
    QVERIFY((*live)->remove());
    QVERIFY(!std::filesystem::exists((*live)->path()));
    core::HapticFrame frame;
    frame.tools = 1;
    QVERIFY((*live)->tryPush(frame)); // the mapping outlives the name
}

void TestCrashRing::writerAndDrainRunTogether() {
    constexpr std::uint64_t kFrames = 60'000;
    auto ring = CrashRing::create(settings());
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
            ordered = ordered && out[i].header.index == next && out[i].tool[0].tissue[5] == static_cast<double>(next);
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
