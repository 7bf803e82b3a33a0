// SPDX-License-Identifier: GPL-3.0-or-later
// Friction sets in as the session's device can render it, and a replay, which has the device's stored data
// alone, has the same friction.
#include "app/exercises/urethra_insertion/session/device_friction.h"
#include "catalogue/catalogue.h"
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "session/device_json.h"
#include "session/exercise_kind.h"
#include "session/friction_felt.h"
#include "session/session_setup.h"
#include "session/station.h"
#include "support/urethra_bench.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Vec3;

namespace {

const session::ExerciseKind& kind() {
    return **session::exerciseKind("urethra_insertion");
}

/// Level 3 on P1's simulated mechanism.
session::SessionSetup onMechanism() {
    static const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    auto station = session::scriptedStation(kind(), *catalogue->find("urethra_insertion", 3), "expert", 1);
    if (!station)
        qFatal("%s", station.error().message.c_str());
    session::SessionSetup setup;
    setup.level = *catalogue->find("urethra_insertion", 3);
    setup.devices = {station->tools[0].device->descriptor()};
    setup.mappings = station->mappings();
    return setup;
}

/// The tissue's force on the endoscope at the bladder neck, advanced at 10 mm/s.
Vec3 forceAtTheNeck(const session::SessionSetup& setup) {
    const auto& p = setup.level.parameters.as<simulation::UrethraInsertionParameters>();
    const auto scene = kind().makeScene(setup);
    const simulation::UrethraCentreline line(p.anatomy);
    simulation::SceneInput in;
    in.started = in.forceReady = true;
    in.tools.count = 1;
    in.tools.tools[0] = tests::onTheLine(p, line.length_m() + 0.001);
    in.tools.tools[0].v_WT = p.pose.vectorToW(0.010 * line.at(line.length_m()).t_A);
    realtime::TickSource ticks;
    simulation::SceneOutput out;
    for (int n = 0; n < 3; ++n)
        scene->respond(ticks.next(0), in, out);
    return out.tissue.tools[0].force;
}

} // namespace

class TestDeviceFriction : public QObject {
    Q_OBJECT
private slots:
    void countAtTheTip();
    void theSmallerDampingHolds();
    void aScaledWorkspaceScalesBoth();
    void theSceneHasItsDevicesFriction();
    void storedDeviceGivesTheSameForce();
    void aCompensationHoldsIfItHelpsAndDoesNoHarm();
};

void TestDeviceFriction::countAtTheTip() {
    const session::SessionSetup setup = onMechanism();
    const double count =
        session::tipCount_m(setup.devices[0]); // 40960 counts a turn on arms of 0.1 to 0.15 m
    QVERIFY2(count > 12e-6 && count < 25e-6, qPrintable(QString::number(count)));
    devices::DeviceDescriptor coarse = setup.devices[0];
    for (auto& axis : coarse.axes)
        axis.resolution *= 3.0;
    QVERIFY(std::abs(session::tipCount_m(coarse) - 3.0 * count) < 0.01 * count);
    const auto pointer = session::keyboardMouseStation({}, kind(), {});
    QVERIFY(pointer.has_value());
    const devices::DeviceDescriptor& mouse = pointer->tools[0].device->descriptor();
    QVERIFY(std::abs(session::tipCount_m(mouse) - mouse.axes[0].resolution) < 1e-15);
    devices::DeviceDescriptor unknown = setup.devices[0];
    unknown.kinematics = "hexapod";
    QCOMPARE(session::tipCount_m(unknown), 0.0);
    QCOMPARE(session::onDevice({}, unknown, {}).count_m, simulation::UrethraForceSettings{}.count_m);
}

void TestDeviceFriction::theSmallerDampingHolds() {
    devices::DeviceDescriptor device = onMechanism().devices[0];
    simulation::UrethraForceSettings law;
    law.maximumDamping_Ns_per_m = 40.0;
    device.maximumDamping_Ns_per_m = 30.0;
    QCOMPARE(session::onDevice(law, device, {}).maximumDamping_Ns_per_m, 30.0);
    device.maximumDamping_Ns_per_m = 60.0;
    QCOMPARE(session::onDevice(law, device, {}).maximumDamping_Ns_per_m, 40.0);
    QCOMPARE(session::onDevice(law, device, {}).count_m, session::tipCount_m(device));
    device.maximumDamping_Ns_per_m = 0.0; // a device that states none leaves the law its own
    QCOMPARE(session::onDevice(law, device, {}).maximumDamping_Ns_per_m, 40.0);
}

void TestDeviceFriction::aScaledWorkspaceScalesBoth() {
    devices::DeviceDescriptor device = onMechanism().devices[0];
    device.maximumDamping_Ns_per_m = 30.0;
    const devices::WorkspaceMapping twice{.scale = 2.0};
    const simulation::UrethraForceSettings felt = session::onDevice({}, device, twice);
    QCOMPARE(felt.maximumDamping_Ns_per_m,
             15.0); // 2 mm of W are 1 mm of the hand: 15 N·s/m there are 30 here
    QCOMPARE(felt.count_m, 2.0 * session::tipCount_m(device));
}

void TestDeviceFriction::theSceneHasItsDevicesFriction() {
    session::SessionSetup setup = onMechanism();
    setup.devices[0].maximumDamping_Ns_per_m = 50.0;
    const Vec3 usual = forceAtTheNeck(setup);
    setup.devices[0].maximumDamping_Ns_per_m = 10.0;
    const Vec3 weak = forceAtTheNeck(setup);
    // μN = 0.92 N: V/√(V² + V₀²) with V₀ = 18 and 92 mm/s; what else resists is the same.
    QVERIFY2(std::abs((usual - weak).norm() - (0.439 - 0.099)) < 0.01,
             qPrintable(QString::number((usual - weak).norm())));
    setup.devices[0].maximumDamping_Ns_per_m = 500.0; // the level's own limit, 50
    QVERIFY((forceAtTheNeck(setup) - usual).norm() < 1e-12);
}

void TestDeviceFriction::storedDeviceGivesTheSameForce() {
    session::SessionSetup setup = onMechanism();
    setup.devices[0].maximumDamping_Ns_per_m = 33.0 / 7.0;
    const Vec3 lived = forceAtTheNeck(setup);
    const auto stored = session::descriptorFromJson(session::toJson(setup.devices[0]));
    QVERIFY(stored.has_value());
    setup.devices[0] = *stored;
    QVERIFY(forceAtTheNeck(setup) == lived);
}

/// What a hand feels of a gimbal's friction: sideways and along, from the lowest speed on.
void TestDeviceFriction::aCompensationHoldsIfItHelpsAndDoesNoHarm() {
    session::FrictionFelt good;
    good.rows = {{"sideways", 0.001, 0.10, 0.10}, // all of it where it breaks away
                 {"sideways", 0.020, 0.12, 0.11},
                 {"sideways", 0.100, 0.20, 0.12}, // of 0.10 N, 0.08 N are taken
                 {"along", 0.001, 0.30, 0.30},
                 {"along", 0.150, 0.60, 0.40}};
    good.heldBefore_N = good.heldAfter_N = 0.0004;
    good.workBefore_J = 0.05;
    good.workAfter_J = 0.02;
    QVERIFY(good.holds());
    const auto but = [&good](auto change) {
        session::FrictionFelt felt = good;
        change(felt);
        return felt.holds();
    };
    for (std::size_t row = 0; row < good.rows.size(); ++row) // it pushes the hand along
        QVERIFY(!but([row](auto& felt) { felt.rows[row].after_N = -0.01; }));
    QVERIFY(!but([](auto& felt) { felt.rows[2].after_N = 0.15; })); // takes too little of it in motion
    QVERIFY(!but([](auto& felt) { felt.rows[4].after_N = 0.45; }));
    QVERIFY(!but([](auto& felt) { felt.rows[3].before_N = 0.40; })); // of which more is asked then
    QVERIFY(but([](auto& felt) { felt.rows[1].after_N = 0.12; }));   // a slow hand need not be helped
    QVERIFY(!but([](auto& felt) { felt.workAfter_J = -0.001; }));
    QVERIFY(!but([](auto& felt) { felt.heldAfter_N = 0.002; }));
    QVERIFY(but([](auto& felt) { felt.heldAfter_N = 0.0013; }));
}

QTEST_GUILESS_MAIN(TestDeviceFriction)
#include "test_device_friction.moc"
