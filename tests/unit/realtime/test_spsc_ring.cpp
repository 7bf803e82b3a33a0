// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/spsc_ring.h"

#include "core/random.h"

#include <QtTest>
#include <array>
#include <cstdint>
#include <thread>

using chiron::realtime::SpscRing;

namespace {
struct Item {
    std::uint64_t number = 0;
    std::array<std::uint64_t, 7> check{};
};
Item itemOf(std::uint64_t n) {
    Item item;
    item.number = n;
    item.check.fill(~n);
    return item;
}
bool isWhole(const Item& item) {
    for (const auto c : item.check)
        if (c != ~item.number)
            return false;
    return true;
}
} // namespace

class TestSpscRing : public QObject {
    Q_OBJECT
private slots:
    void holdsExactlyItsCapacityInOrder() {
        SpscRing<int, 4> ring;
        int value = -1;
        QVERIFY(!ring.tryPop(value));
        QCOMPARE(value, -1);
        for (int n = 0; n < 4; ++n)
            QVERIFY(ring.tryPush(n));
        QVERIFY(!ring.tryPush(99));
        for (int n = 0; n < 4; ++n) {
            QVERIFY(ring.tryPop(value));
            QCOMPARE(value, n);
        }
        QVERIFY(!ring.tryPop(value));
    }

    void behavesLikeAQueueOverManyRandomTurns() {
        SpscRing<std::uint64_t, 8> ring;
        chiron::core::Random random(20261120);
        std::uint64_t pushed = 0;
        std::uint64_t popped = 0;
        for (int turn = 0; turn < 100'000; ++turn) {
            if (random.below(2) == 0) {
                QCOMPARE(ring.tryPush(pushed), pushed - popped < 8);
                pushed += pushed - popped < 8 ? 1 : 0;
            } else {
                std::uint64_t value = 0;
                const bool expected = pushed != popped;
                QCOMPARE(ring.tryPop(value), expected);
                if (expected)
                    QCOMPARE(value, popped++);
            }
        }
        QVERIFY(popped > 10'000);
    }

    void everyItemArrivesOnceWholeAndInOrder() {
        constexpr std::uint64_t kItems = 300'000;
        SpscRing<Item, 64> ring;
        std::thread producer([&] {
            for (std::uint64_t n = 0; n < kItems; ++n)
                while (!ring.tryPush(itemOf(n)))
                    std::this_thread::yield();
        });
        std::uint64_t expected = 0;
        std::uint64_t wrong = 0;
        while (expected < kItems) {
            Item item;
            if (!ring.tryPop(item)) {
                std::this_thread::yield();
                continue;
            }
            wrong += (item.number == expected && isWhole(item)) ? 0 : 1;
            ++expected;
        }
        producer.join();
        Item none;
        QVERIFY(!ring.tryPop(none));
        QCOMPARE(wrong, 0u);
    }
};

QTEST_APPLESS_MAIN(TestSpscRing)
#include "test_spsc_ring.moc"
