// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/driver_catalogue.h"
#include "realtime/guarded_run.h"
#include "support/driver_request.h"

#include <QtTest>
#include <variant>

using namespace chiron;
using namespace chiron::tests;

namespace {

template <class Mailbox> Mailbox* mailboxOf(const devices::DriverTool& tool) {
    Mailbox* const* found = std::get_if<Mailbox*>(&tool.input);
    return found ? *found : nullptr;
}

} // namespace

/// Every driver of the catalogue, with each of its kinematics and as each shape of tool that it can be:
/// 10,000 ticks in which nothing is allocated, locked or thrown. A new driver is asked by its line in the
/// catalogue.
class TestEveryDriverGuard : public QObject {
    Q_OBJECT
private slots:
    void itsDevices_data() {
        QTest::addColumn<QString>("driver");
        QTest::addColumn<QString>("kinematics");
        for (const devices::Driver* driver : devices::driverCatalogue())
            for (const devices::KinematicsEntry& kinematics : driver->kinematics)
                QTest::newRow((std::string(driver->id) + ", " + std::string(kinematics.id)).c_str())
                    << QString::fromStdString(std::string(driver->id))
                    << QString::fromStdString(std::string(kinematics.id));
    }
    void itsDevices() {
        QFETCH(QString, driver);
        QFETCH(QString, kinematics);
        const devices::Driver& asked = *devices::findDriver(driver.toStdString());
        int shapes = 0;
        for (const devices::ToolShape shape :
             {devices::ToolShape::point, devices::ToolShape::endoscope, devices::ToolShape::grasper}) {
            devices::DriverRequest request = requestForAnyDriver(kinematics.toStdString());
            request.shape = shape;
            auto made = asked.open(std::move(request));
            if (!made) { // not a shape of this driver's devices
                QVERIFY2(made.error().code == core::ErrorCode::badInput ||
                             made.error().code == core::ErrorCode::wrongUse,
                         made.error().message.c_str());
                continue;
            }
            ++shapes;
            const devices::DriverTool& tool = made->front();
            if (const auto opened = tool.device->open(); !opened) {
                QVERIFY2(asked.discover().empty(), opened.error().message.c_str());
                QSKIP("no such device is connected");
            }
            haptics::LiveInputs inputs;
            FrameStore store;
            LoopBench bench({{*tool.device, {}}}, inputs, store, apexScene());
            const ForbiddenCounts counts =
                guardedRun(*bench.loop, inputs, mailboxOf<devices::PointerMailbox>(tool),
                           mailboxOf<devices::EndoscopeMailbox>(tool));
            QVERIFY2(counts.total() == 0, words(counts));
            QVERIFY(!store.frames.empty());
        }
        QVERIFY(shapes > 0);
    }
};

QTEST_APPLESS_MAIN(TestEveryDriverGuard)
#include "test_every_driver_guard.moc"
