// SPDX-License-Identifier: GPL-3.0-or-later
// What a mechanism did before it was reset leaves nothing behind: it goes on to the last bit like one that
// was never used.
#include "mechanisms/fingertip_arm_plant.h"
#include "mechanisms/fingertip_platform.h"
#include "mechanisms/five_bar_plant.h"
#include "mechanisms/gimbal_plant.h"
#include "mechanisms/hand.h"
#include "mechanisms/jaw.h"
#include "mechanisms/rotation_vector.h"
#include "mechanisms/wrist.h"

#include <QtTest>
#include <cmath>
#include <vector>

using namespace chiron;
using namespace chiron::mechanisms;
using core::Quat;
using core::Vec3;

namespace {

constexpr double kTick = core::kTickSeconds;
/// No multiple of any sensor's period.
constexpr int kUsed = 1003;

using Told = std::vector<double>;

void tell(Told& told, const Vec3& v) {
    told.insert(told.end(), {v.x(), v.y(), v.z()});
}
void tell(Told& told, const Quat& q) {
    told.insert(told.end(), {q.w(), q.x(), q.y(), q.z()});
}
void tell(Told& told, const Plant& plant) {
    const ToolMotion m = plant.motion();
    tell(told, m.p_DT);
    tell(told, m.q_DT);
    tell(told, m.v_DT);
    tell(told, m.w_DT);
    tell(told, plant.measured_D().force);
    tell(told, plant.measured_D().torque);
    told.push_back(plant.saturated() ? 1.0 : 0.0);
    told.insert(told.end(), plant.encoderCounts().begin(), plant.encoderCounts().end());
}

/// What a plant tells at once, after a step that nobody asked for, and under efforts and a hand.
template <class Mechanism, class Also>
Told course(Mechanism& plant, const AxisEfforts& scale, double torque_Nm, Also also) {
    Told told;
    const auto all = [&] {
        tell(told, plant);
        told.push_back(plant.energy_J());
        also(told);
    };
    all();
    plant.step(0.25 * kTick, {});
    plant.endTick();
    all();
    for (int tick = 0; tick < kUsed; ++tick) {
        const double t = kTick * tick;
        AxisEfforts efforts = scale;
        for (double& effort : efforts)
            effort *= std::sin(5.0 * t + 0.3);
        plant.beginTick(efforts, true);
        for (int step = 0; step < plant.substeps(); ++step)
            plant.step(kTick / plant.substeps(), {Vec3(0.4 * std::sin(3.0 * t), 0.3, -0.2),
                                                  torque_Nm * Vec3(1.0, std::cos(2.0 * t), 0.5)});
        plant.endTick();
        all();
    }
    return told;
}

/// Leaves it in motion, with its motors at their limits.
void strain(Plant& plant) {
    AxisEfforts efforts;
    efforts.fill(1e3);
    plant.beginTick(efforts, true);
    plant.step(kTick / plant.substeps(), {});
    plant.endTick();
}

HandIntention intention(int tick) {
    const double t = kTick * tick;
    HandIntention wanted;
    wanted.p_DDesired = {0.02 * std::sin(4.0 * t), -0.02, 0.05};
    wanted.v_DDesired = {0.08 * std::cos(4.0 * t), 0.0, 0.0};
    wanted.q_DDesired = turned(Quat::Identity(), {0.3 * std::sin(3.0 * t), 0.2, -0.1});
    wanted.w_DDesired = {0.9 * std::cos(3.0 * t), 0.0, 0.0};
    wanted.buttons = 1;
    wanted.jaw_rad = 1.0 + 0.3 * std::sin(5.0 * t);
    return wanted;
}

/// A hand, its wrist and the handle in its fingers.
struct Arm {
    Hand hand{HandParameters{}, 3, 0.12};
    Wrist wrist{HandParameters{}, 4, 0.001};
    Jaw jaw{JawParameters{}, 2};

    void reset() {
        hand.reset({0.0, -0.02, 0.05}, turned(Quat::Identity(), {0.1, 0.0, 0.0}));
        wrist.reset(turned(Quat::Identity(), {0.1, 0.0, 0.0}));
        jaw.reset();
    }
    Told course() {
        Told told;
        all(told);
        integrate();
        all(told);
        for (int tick = 0; tick < kUsed; ++tick) {
            hand.beginTick(intention(tick));
            wrist.beginTick(hand.acting());
            jaw.advance(hand.acting().jaw_rad);
            integrate();
            all(told);
        }
        return told;
    }

private:
    void integrate() {
        hand.integrate(0.25 * kTick, {0.1, 0.0, 0.0});
        wrist.integrate(0.25 * kTick, {0.0, 0.001, 0.0});
    }
    void all(Told& told) const {
        tell(told, hand.p_D());
        tell(told, hand.v_D());
        tell(told, hand.acting().p_DDesired);
        tell(told, wrist.q_D());
        tell(told, wrist.w_D());
        told.insert(told.end(), {static_cast<double>(hand.acting().buttons), jaw.angle_rad(),
                                 static_cast<double>(jaw.counts())});
    }
};

Told course(FingertipPlatform& platform) {
    Told told;
    for (int tick = -1; tick < 403; ++tick) {
        if (tick >= 0)
            platform.tick({1.5 - std::cos(0.02 * tick), 0.2, 0.1 * std::sin(0.01 * tick)}, true);
        const core::DisplayPose& is = platform.truth();
        told.insert(told.end(),
                    {is.normalForce_N, is.pitch_rad, is.roll_rad, platform.sensedForce_N(),
                     platform.sensedPitch_rad(), platform.sensedRoll_rad(), platform.saturated() ? 1.0 : 0.0,
                     platform.plant().padForce_N(), platform.plant().energy_J()});
        tell(told, platform.plant().motors());
        for (const int counts : platform.forceSensors().counts())
            told.push_back(counts);
    }
    return told;
}

} // namespace

class TestMechanismsAnew : public QObject {
    Q_OBJECT
private slots:
    void gimbal() {
        GimbalPlantParameters p;
        p.sampleDelay_ticks = 2;
        GimbalPlant used(p), fresh(p);
        const auto nothing = [](Told&) {};
        const AxisEfforts scale{0.25, -0.3, 0.0, 1.2};
        course(used, scale, 0.0, nothing);
        strain(used);
        QVERIFY(used.saturated());
        used.reset({0.15, -0.1, 0.3, 0.2});
        fresh.reset({0.15, -0.1, 0.3, 0.2});
        QVERIFY(course(used, scale, 0.0, nothing) == course(fresh, scale, 0.0, nothing));
    }

    void fiveBar() {
        FiveBarPlantParameters p;
        p.sampleDelay_ticks = 2;
        FiveBarPlant used(p), fresh(p);
        FiveBarVector q;
        const auto theta = FiveBarKinematics(p.geometry).inverse({0.0, -0.03, 0.05});
        QVERIFY(theta);
        q << (*theta)[0], (*theta)[1], 0.2, -0.1, 0.4;
        const auto nothing = [](Told&) {};
        const AxisEfforts scale{0.3, -0.25, 0.06, 0.05, 0.004};
        course(used, scale, 0.012, nothing);
        strain(used);
        QVERIFY(used.saturated());
        used.reset(q);
        fresh.reset(q);
        QVERIFY(course(used, scale, 0.012, nothing) == course(fresh, scale, 0.012, nothing));
    }

    void arm_data() {
        QTest::addColumn<int>("tiltPeriod_ticks");
        QTest::newRow("as it is") << FingertipArmParameters{}.imu.tiltPeriod_ticks;
        QTest::newRow("tilt at every tick") << 1; // takes the first tick's acceleration
    }
    void arm() {
        QFETCH(int, tiltPeriod_ticks);
        FingertipArmParameters p;
        p.imu.tiltPeriod_ticks = tiltPeriod_ticks;
        FingertipArmPlant used(p, 5), fresh(p, 5);
        const auto run = [](FingertipArmPlant& plant) {
            return course(plant, {}, 0.004, [&](Told& told) {
                told.push_back(plant.jawCounts());
                tell(told, plant.imu().attitude());
                tell(told, plant.imu().rate_T());
                tell(told, plant.imu().acceleration_T());
            });
        };
        used.holdLever(0.7);
        run(used);
        used.reset({0.03, -0.05, 0.08});
        fresh.reset({0.03, -0.05, 0.08});
        QVERIFY(run(used) == run(fresh));
    }

    void handWristAndJaw() {
        Arm used, fresh;
        used.reset();
        used.course();
        used.reset();
        fresh.reset();
        QVERIFY(used.course() == fresh.course());
    }

    void platform() {
        FingertipPlatformParameters p;
        p.pad.relaxation = 0.3;
        FingertipPlatform used(p, 8), fresh(p, 8);
        used.shiftFinger(-2e-4);
        course(used);
        used.reset();
        QVERIFY(course(used) == course(fresh));
    }
};

QTEST_APPLESS_MAIN(TestMechanismsAnew)
#include "test_mechanisms_anew.moc"
