// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/ring_recovery.h"
#include "unit/recording/ring_support.h"

#include <QtTest>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace chiron;
using namespace chiron::recording;
using namespace chiron::tests;

class TestRingRecovery : public QObject {
    Q_OBJECT
private slots:
    void anOlderRingIsNotOverwritten();
    void aLivingRingIsNotRecovered();
    void recoversWhatWasNotCommitted();
    void tornSlotEndsTheRecovery_data();
    void tornSlotEndsTheRecovery();
    void damagedHeadersAreRefused();
    void killedWriterLosesAtMostOneFrame();
    void killedWriterWithADrainToo();
    void listsAndRemovesRings();

private:
    RingFolder m_rings;
    void killAtRandomMoments(std::uint64_t commitEvery);
};

void TestRingRecovery::anOlderRingIsNotOverwritten() {
    const RingSettings s = m_rings.settings();
    const auto path = leaveBehind(s, 10, 0);
    QCOMPARE(CrashRing::create(s).error().code, core::ErrorCode::storage);
    QCOMPARE(recoverRing(path)->frames().size(), std::size_t{10});
}

void TestRingRecovery::aLivingRingIsNotRecovered() {
    auto ring = CrashRing::create(m_rings.settings());
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

void TestRingRecovery::recoversWhatWasNotCommitted() {
    const RingSettings s = m_rings.settings(2);
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
    auto expected = HapticTrace(1, 2).take(300);
    for (std::size_t i = 0; i < 180; ++i)
        QVERIFY(sameFrame(ring->frames()[i], expected[120 + i]));
}

void TestRingRecovery::tornSlotEndsTheRecovery_data() {
    QTest::addColumn<int>("offset");
    QTest::newRow("number") << 0;
    QTest::newRow("checksum") << 8;
    QTest::newRow("layout and tools") << 20;
    QTest::newRow("first tick byte") << static_cast<int>(sizeof(SlotHeader) + 8);
    QTest::newRow("last used byte") << static_cast<int>(sizeof(SlotHeader) + usedFrameBytes(1) - 1);
}

void TestRingRecovery::tornSlotEndsTheRecovery() {
    QFETCH(int, offset);
    const auto path = leaveBehind(m_rings.settings(), 50, 0);
    patch(path, kRingHeaderBytes + 40 * slotBytesFor(1) + static_cast<std::size_t>(offset), 0x10);
    const auto ring = recoverRing(path);
    QVERIFY(ring);
    QCOMPARE(ring->frames().size(), std::size_t{40});
}

void TestRingRecovery::damagedHeadersAreRefused() {
    const auto path = leaveBehind(m_rings.settings(), 5, 0);
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
    patch(path, offsetof(RingHeader, frameLayout),
          0x03); // 2 becomes 1: frames of a program before quantities
    QVERIFY(recoverRing(path).error().message.find("expected frame layout 2, found 1") != std::string::npos);
    patch(path, offsetof(RingHeader, frameLayout), 0x03);
    for (const std::uintmax_t size : {std::uintmax_t{0}, std::uintmax_t{100}, std::uintmax_t{5000}}) {
        std::filesystem::resize_file(path, size);
        QCOMPARE(recoverRing(path).error().code, core::ErrorCode::badInput);
    }
    QCOMPARE(recoverRing(m_rings.folder.path().toStdString()).error().code,
             core::ErrorCode::storage); // a folder
}

// A child pushes frames and counts them in shared memory; it is killed once the count passes a random number.
void TestRingRecovery::killAtRandomMoments(std::uint64_t commitEvery) {
    void* memory = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    QVERIFY(memory != MAP_FAILED);
    auto& begun = *new (memory) std::atomic<std::uint64_t>(0);
    core::Random random = core::Random::stream(commitEvery, "kill moments");
    for (int round = 0; round < 12; ++round) {
        begun = 0;
        const RingSettings s = m_rings.settings();
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
        const auto ring =
            recoverRing(s.folder / (ringFilePrefix(s.database) + std::to_string(s.session) + kRingSuffix));
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

void TestRingRecovery::killedWriterLosesAtMostOneFrame() {
    killAtRandomMoments(1'000'000'000);
}
void TestRingRecovery::killedWriterWithADrainToo() {
    killAtRandomMoments(7);
}

void TestRingRecovery::listsAndRemovesRings() {
    RingSettings s = m_rings.settings();
    s.database[0] = 1;
    QVERIFY(listRings(s.folder, s.database).empty());
    const auto path = leaveBehind(s, 1, 0);
    QCOMPARE(listRings(s.folder, s.database), std::vector<std::filesystem::path>{path});
    std::vector<std::filesystem::path> several{path}; // in the order of their names, not of their making
    for (const std::int64_t session : {905, 901, 904, 902, 903}) {
        RingSettings more = s;
        more.session = session;
        several.push_back(leaveBehind(more, 1, 0));
    }
    std::sort(several.begin(), several.end());
    QCOMPARE(listRings(s.folder, s.database), several);
    for (const auto& one : several)
        if (one != path)
            QVERIFY(recoverRing(one)->remove());
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
    auto live = CrashRing::create(m_rings.settings());
    QVERIFY((*live)->remove());
    QVERIFY(!std::filesystem::exists((*live)->path()));
    core::HapticFrame frame;
    frame.tools = 1;
    QVERIFY((*live)->tryPush(frame)); // the mapping outlives the name
}

QTEST_APPLESS_MAIN(TestRingRecovery)
#include "test_ring_recovery.moc"
