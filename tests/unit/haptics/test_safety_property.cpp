// SPDX-License-Identifier: GPL-3.0-or-later
// The property test of the supervisor: over a million random ticks no row of the table (models.md §5) is ever
// broken, and with any one guard switched off the same check finds that row broken. (The passivity row:
// test_safety_passivity.)
#include "unit/haptics/safety_episode.h"

#include <QtTest>
#include <map>

using namespace chiron;
using haptics::GuardMask;
using test::SafetyEpisode;

namespace {

constexpr int kTicksAnEpisode = 2500;

} // namespace

class TestSafetyProperty : public QObject {
    Q_OBJECT
private slots:
    void noRowIsEverBroken();
    void eachGuardSwitchedOffIsFound_data();
    void eachGuardSwitchedOffIsFound();
    void sameInputsGiveTheSameBits();
};

void TestSafetyProperty::noRowIsEverBroken() {
    int live = 0;
    constexpr int kEpisodes = 420; // 1,050,000 ticks
    for (std::uint64_t seed = 0; seed < kEpisodes; ++seed) {
        SafetyEpisode episode(seed, GuardMask());
        for (int tick = 0; tick < kTicksAnEpisode; ++tick) {
            const std::string broken = episode.tick();
            if (!broken.empty()) {
                QFAIL(qPrintable(
                    QString("%1 broken: seed %2, tick %3").arg(broken.c_str()).arg(seed).arg(tick)));
            }
        }
        live += episode.everLive() ? 1 : 0;
    }
    // The check would be empty if force never came on.
    QVERIFY2(live > kEpisodes / 2, qPrintable(QString::number(live)));
}

void TestSafetyProperty::eachGuardSwitchedOffIsFound_data() {
    QTest::addColumn<unsigned>("guard");
    QTest::addColumn<QString>("row");
    QTest::newRow("caps") << GuardMask::kCaps << "caps";
    QTest::newRow("slew") << GuardMask::kSlew << "slew";
    QTest::newRow("arming") << GuardMask::kArming << "arming";
    QTest::newRow("over-velocity") << GuardMask::kOverVelocity << "over-velocity";
    QTest::newRow("sanity") << GuardMask::kSanity << "sanity";
    QTest::newRow("watchdog") << GuardMask::kWatchdog << "watchdog";
    QTest::newRow("stop") << GuardMask::kStop << "stop";
    QTest::newRow("frozen window") << GuardMask::kHeartbeat << "frozen window";
    QTest::newRow("finite") << GuardMask::kFinite << "finite";
    QTest::newRow("pause") << GuardMask::kPause << "pause";
}

void TestSafetyProperty::eachGuardSwitchedOffIsFound() {
    QFETCH(unsigned, guard);
    QFETCH(QString, row);
    std::map<std::string, int> found;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SafetyEpisode episode(seed, GuardMask::without(guard));
        for (int tick = 0; tick < kTicksAnEpisode; ++tick) {
            const std::string broken = episode.tick();
            if (!broken.empty()) {
                ++found[broken];
                break;
            }
        }
    }
    QVERIFY2(found[row.toStdString()] > 0, qPrintable("the " + row + " row was never found broken"));
}

void TestSafetyProperty::sameInputsGiveTheSameBits() {
    for (std::uint64_t seed = 1000; seed < 1010; ++seed) {
        SafetyEpisode a(seed, GuardMask());
        SafetyEpisode b(seed, GuardMask());
        for (int tick = 0; tick < kTicksAnEpisode; ++tick) {
            a.tick();
            b.tick();
        }
        QCOMPARE(a.digest(), b.digest());
    }
}

QTEST_APPLESS_MAIN(TestSafetyProperty)
#include "test_safety_property.moc"
