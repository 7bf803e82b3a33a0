// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/simulated_second_finger.h"
#include "realtime/guarded_run.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::tests;

namespace {

class Presser final : public mechanisms::HandStrategy {
public:
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = core::Vec3(0.01 * std::sin(seen.time_s), 0.0, 0.05);
        wanted.jaw_rad = 0.3;
        return wanted;
    }
};

} // namespace

/// 10,000 ticks of two fingers of one hand, through every limit: nothing is allocated, locked or thrown.
class TestFingertipGuard : public QObject {
    Q_OBJECT
private slots:
    void twoFingers() {
        auto first =
            std::move(devices::SimulatedFingertipDevice::create({}, std::make_unique<Presser>()).value());
        auto second = std::move(
            devices::SimulatedSecondFinger::create(*first, {0.018, 0.0, 0.0}, 2, std::make_unique<Presser>())
                .value());
        QVERIFY(first->open().has_value() && second->open().has_value());
        realtime::TickSource ticks;
        resetForbiddenCounts();
        double most = 0.0;
        for (int n = 0; n < kTicks; ++n) {
            const realtime::HapticTick now = ticks.next(0);
            devices::ForceCommand command;
            command.enabled = n % 3000 > 100;
            command.display = {2.0 - 2.2 * std::cos(0.01 * n), 0.6 * std::sin(0.003 * n),
                               -0.4 * std::sin(0.004 * n)};
            const TickGuard guard;
            for (devices::IDevice* device : {static_cast<devices::IDevice*>(first.get()),
                                             static_cast<devices::IDevice*>(second.get())}) {
                device->show(now, {});
                device->read(now);
                device->command(now, command);
            }
            most = std::max(most, second->platform().truth().normalForce_N);
        }
        QVERIFY2(forbiddenCounts().total() == 0, words(forbiddenCounts()));
        QVERIFY2(most > 3.3 && most <= 4.0,
                 qPrintable(QString::number(most))); // asked for 4.2 N: the pad's limit was met and kept
        first->close();
        second->close();
    }
};

QTEST_APPLESS_MAIN(TestFingertipGuard)
#include "test_fingertip_guard.moc"
