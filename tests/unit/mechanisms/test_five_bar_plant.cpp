// SPDX-License-Identifier: GPL-3.0-or-later
#include "five_bar_loop.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <vector>

using namespace chiron;
using core::Vec3;
using core::Wrench;
using mechanisms::AxisEfforts;
using mechanisms::FiveBarDynamics;
using mechanisms::FiveBarKinematics;
using mechanisms::FiveBarPlant;
using mechanisms::FiveBarPlantParameters;
using mechanisms::FiveBarVector;

namespace {

FiveBarVector at(const Vec3& p_D, double pitch = 0.2, double yaw = 0.0, double roll = 0.0) {
    return tests::fiveBarAt(p_D, {pitch, yaw, roll});
}

FiveBarPlantParameters lossless() {
    FiveBarPlantParameters p;
    for (auto& friction : p.friction)
        friction = {};
    p.tendonDamping.fill(0.0);
    p.gravityFeedForward = false;
    p.counterbalance = 0.0;
    p.minimum.fill(-10.0);
    p.maximum.fill(10.0);
    return p;
}

void tick(FiveBarPlant& plant, const AxisEfforts& efforts, bool enabled, const Wrench& wrench) {
    plant.beginTick(efforts, enabled);
    for (int i = 0; i < plant.substeps(); ++i)
        plant.step(core::kTickSeconds / plant.substeps(), wrench);
    plant.endTick();
}

AxisEfforts effortsOf(const FiveBarVector& q, const Wrench& wrench) {
    FiveBarDynamics dynamics{FiveBarPlantParameters{}};
    dynamics.place(q);
    const FiveBarVector tau = dynamics.efforts(wrench);
    return {tau[0], tau[1], tau[2], tau[3], tau[4]};
}

} // namespace

class TestFiveBarPlant : public QObject {
    Q_OBJECT
private slots:
    /// Free, without friction, under its full weight: a wrong or missing Coriolis term shows as a drift.
    /// Semi-implicit Euler errs in proportion to the step, so the drift must fall as the step does.
    void energyIsKeptWithoutLosses() {
        const auto drift = [](int substeps) {
            FiveBarPlantParameters p = lossless();
            p.substeps = substeps;
            FiveBarPlant plant(p);
            plant.reset(at(Vec3(0.0, -0.01, 0.08), 0.6, 0.1, 0.0));
            const double start = plant.energy_J();
            double worst = 0.0;
            const Wrench push{Vec3(0.0, 1.5, 2.5), Vec3(0.05, 0.06, 0.002)};
            for (int n = 0; n < 40; ++n) // into a fast, coupled motion
                tick(plant, {}, false, push);
            const double before = plant.energy_J();
            for (int n = 0; n < 60; ++n) {
                tick(plant, {}, false, {});
                worst = std::max(worst, std::abs(plant.energy_J() - before));
            }
            return worst / std::abs(before - start);
        };
        const double coarse = drift(4), fine = drift(64);
        qInfo("drift %.2e at 4 kHz, %.2e at 64 kHz", coarse, fine);
        QVERIFY2(fine < 2e-3, qPrintable(QString::number(fine)));
        QVERIFY2(fine < coarse / 8.0, qPrintable(QString("%1 %2").arg(coarse).arg(fine)));
    }

    /// With friction, motors off: what the hand puts in is never less than what is there.
    void passiveWithFriction() {
        FiveBarPlant plant{FiveBarPlantParameters{}};
        plant.reset(at(Vec3(0.0, 0.0, 0.05), 0.6));
        const double start = plant.energy_J();
        double work = 0.0, highest = 0.0;
        const double dt = core::kTickSeconds / plant.substeps();
        for (int n = 0; n < 8000; ++n) {
            const double t = n * 1e-3;
            const Wrench push{
                Vec3(0.0, 1.5 * std::sin(9.0 * t), 1.5 * std::sin(7.0 * t)),
                Vec3(0.04 * std::sin(11.0 * t), 0.03 * std::cos(5.0 * t), 0.003 * std::sin(13.0 * t))};
            plant.beginTick({}, false);
            for (int i = 0; i < plant.substeps(); ++i) {
                const auto before = plant.motion();
                plant.step(dt, push);
                const auto after = plant.motion();
                work +=
                    dt * 0.5 *
                    (push.force.dot(before.v_DT + after.v_DT) + push.torque.dot(before.w_DT + after.w_DT));
            }
            plant.endTick();
            highest = std::max(highest, plant.energy_J() - start - work);
        }
        QVERIFY(work > 0.05);
        QVERIFY2(highest < 2e-4, qPrintable(QString::number(highest)));
    }

    /// Held still by a torque about the pitch axis, with all of the weight balanced: nothing moves, and the
    /// energy is that of springs which carry the same torque.
    void bristlesAndStopsStoreEnergy() {
        FiveBarPlantParameters p;
        p.counterbalance = 1.0;
        FiveBarPlant held(p); // by friction: tendon and bristle in series
        held.reset(at(Vec3(0.0, 0.0, 0.06), 0.6));
        const double rest = held.energy_J();
        const double small_Nm = 0.5 * p.friction[2].coulomb;
        for (int n = 0; n < 3000; ++n)
            tick(held, {}, false, {Vec3::Zero(), std::min(1.0, n / 1000.0) * small_Nm * Vec3::UnitX()});
        const double springs =
            0.5 * small_Nm * small_Nm * (1.0 / p.tendonStiffness[2] + 1.0 / p.friction[2].bristleStiffness);
        QVERIFY2(std::abs((held.energy_J() - rest) / springs - 1.0) < 0.05,
                 qPrintable(QString::number((held.energy_J() - rest) / springs)));

        for (auto& friction : p.friction)
            friction = {0.0, 0.0, 0.0, friction.viscous};
        FiveBarPlant stopped(p); // by the stop alone: the motor comes along
        stopped.reset(at(Vec3(0.0, 0.0, 0.06), p.mountingPitch_rad + p.maximum[2]));
        const double before = stopped.energy_J(), torque_Nm = 0.1;
        for (int n = 0; n < 3000; ++n)
            tick(stopped, {}, false, {Vec3::Zero(), torque_Nm * Vec3::UnitX()});
        const double stop = 0.5 * torque_Nm * torque_Nm / p.stopStiffness[2];
        QVERIFY2(std::abs((stopped.energy_J() - before) / stop - 1.0) < 0.01,
                 qPrintable(QString::number((stopped.energy_J() - before) / stop)));
    }

    /// P1's largest forces and torques; what is asked for beyond saturates, and says so.
    void motorsGiveP1sLimitsAndNoMore() {
        const FiveBarPlantParameters p;
        double weakest = 100.0;
        for (double y : {-0.075, -0.03, 0.0, 0.03, 0.065}) {
            for (double z : {-0.02, 0.02, 0.06, 0.1, 0.135}) {
                const FiveBarVector q = at(Vec3(0.0, y, z));
                FiveBarDynamics dynamics(p);
                dynamics.place(q);
                for (int n = 0; n < 360; ++n) {
                    const double a = core::radFromDeg(n);
                    const FiveBarVector tau =
                        dynamics.efforts({Vec3(0.0, std::cos(a), std::sin(a)), Vec3::Zero()});
                    weakest =
                        std::min(weakest, p.renderLimit[0] / std::max(std::abs(tau[0]), std::abs(tau[1])));
                }
            }
        }
        QVERIFY2(weakest >= 4.5 && weakest < 4.6, qPrintable(QString::number(weakest)));

        FiveBarPlant plant(p);
        const FiveBarVector q = at(Vec3(0.0, 0.0, 0.06), 0.8, 0.1);
        plant.reset(q);
        const Wrench small{Vec3(0.0, 0.0, 4.4), plant.dynamics().joint().view_D() * 0.009};
        for (int n = 0; n < 20; ++n)
            tick(plant, effortsOf(q, small), true, {-small.force, -small.torque});
        QVERIFY(!plant.saturated());
        QVERIFY2((plant.measured_D().force - small.force).norm() < 0.05,
                 qPrintable(QString::number((plant.measured_D().force - small.force).norm())));
        QVERIFY((plant.measured_D().torque - small.torque).norm() < 0.002);
        plant.reset(q);
        for (int n = 0; n < 20; ++n)
            tick(plant, {10.0, -10.0, 10.0, 10.0, 10.0}, true, {});
        QVERIFY(plant.saturated());
        const FiveBarVector gave = plant.dynamics().efforts(plant.measured_D());
        for (int axis = 0; axis < 5; ++axis)
            QVERIFY2(std::abs(std::abs(gave[axis]) - p.renderLimit[static_cast<std::size_t>(axis)]) < 1e-4,
                     qPrintable(QString::number(gave[axis])));
        QVERIFY(p.renderLimit[2] == 0.150 && p.renderLimit[3] == 0.150 && p.renderLimit[4] == 0.010);
    }

    void counterweightsAndMotorsCarryTheWeight() {
        FiveBarPlantParameters p;
        for (auto& friction : p.friction)
            friction.coulomb = 0.0; // nothing else may hold it
        FiveBarPlant plant(p);
        plant.reset(at(Vec3(0.0, 0.0, 0.06), 0.5, 0.1));
        const auto before = plant.motion();
        for (int n = 0; n < 1000; ++n)
            tick(plant, {}, true, {});
        QVERIFY2((plant.motion().p_DT - before.p_DT).norm() < 1.5e-3,
                 qPrintable(QString::number((plant.motion().p_DT - before.p_DT).norm())));
        QVERIFY(plant.motion().q_DT.angularDistance(before.q_DT) < 0.03);
        FiveBarPlant off(p);
        off.reset(at(Vec3(0.0, 0.0, 0.06), 0.5, 0.1));
        for (int n = 0; n < 300; ++n)
            tick(off, {0.0, 0.0, 0.1, 0.0, 0.0}, false, {}); // disabled: the request is ignored
        QVERIFY(off.motion().p_DT.z() < 0.06 - 2e-3);
        QVERIFY(p.gravityReserve[0] > 0.0);
        FiveBarDynamics dynamics(p); // the reserve is enough everywhere
        for (double y : {-0.075, 0.0, 0.065})
            for (double z : {-0.02, 0.06, 0.135})
                for (double pitch : {-0.5, 0.0, 0.7, 1.6})
                    for (double yaw : {-0.5, 0.0, 0.5}) {
                        dynamics.place(at(Vec3(0.0, y, z), pitch, yaw));
                        const FiveBarVector rest = (1.0 - p.counterbalance) * dynamics.gravity();
                        for (int axis = 0; axis < 5; ++axis)
                            QVERIFY2(std::abs(rest[axis]) <=
                                         p.gravityReserve[static_cast<std::size_t>(axis)] + 1e-12,
                                     qPrintable(QString("axis %1: %2").arg(axis).arg(rest[axis])));
                    }
    }

    void frictionHoldsBelowItsLimit() {
        FiveBarPlant plant{FiveBarPlantParameters{}};
        const FiveBarVector q = at(Vec3(0.0, 0.0, 0.06), 0.6);
        plant.reset(q);
        const auto before = plant.motion();
        for (int n = 0; n < 1000; ++n)
            tick(plant, {}, true, {Vec3(0.0, 0.03, 0.0), Vec3(0.0015, 0.0, 0.0)});
        QVERIFY2((plant.motion().p_DT - before.p_DT).norm() < 100e-6,
                 qPrintable(QString::number((plant.motion().p_DT - before.p_DT).norm())));
        for (int n = 0; n < 500; ++n)
            tick(plant, {}, true, {Vec3(0.0, 0.4, 0.0), Vec3::Zero()});
        QVERIFY((plant.motion().p_DT - before.p_DT).norm() > 5e-3);
    }

    /// The host reads the motors: under load the joints lie where the tendons let them, unseen.
    void tendonsStretchUnseen() {
        FiveBarPlantParameters p;
        for (auto& friction : p.friction)
            friction = {0.0, 0.0, 0.0, friction.viscous};
        FiveBarPlant plant(p);
        const FiveBarVector q = at(Vec3(0.0, 0.0, 0.06), 0.6);
        plant.reset(q);
        const Wrench pull{Vec3(0.0, 3.0, 0.0), Vec3(0.1, 0.0, 0.0)};
        for (int n = 0; n < 3000; ++n) { // the motors hold their angles, as a stiff virtual wall does
            AxisEfforts hold{};
            for (int axis = 0; axis < 5; ++axis) {
                const double k = std::array{15.0, 15.0, 2.0, 2.0, 0.01}[static_cast<std::size_t>(axis)];
                hold[static_cast<std::size_t>(axis)] =
                    k * (q[axis] - plant.motorAngles()[axis]) - 0.01 * k * plant.rates()[axis];
            }
            tick(plant, hold, true, pull);
        }
        const FiveBarVector load = plant.dynamics().efforts(pull);
        for (int axis : {0, 1, 2}) {
            const double stretch = plant.q()[axis] - plant.motorAngles()[axis];
            const double weight = (1.0 - p.counterbalance) * plant.dynamics().gravity()[axis];
            const double expected = (load[axis] - weight) / p.tendonStiffness[static_cast<std::size_t>(axis)];
            QVERIFY2(std::abs(stretch - expected) < 0.02 * std::abs(expected),
                     qPrintable(QString("%1 %2").arg(stretch).arg(expected)));
        }
    }

    void encodersAreOnTheirGridAndDelayed() {
        FiveBarPlantParameters p;
        p.gravityFeedForward = false; // works with the counts
        FiveBarPlantParameters late = p;
        late.sampleDelay_ticks = 3;
        FiveBarPlant a(p), b(late);
        const FiveBarVector q = at(Vec3(0.0, 0.0, 0.06), 0.6);
        a.reset(q);
        b.reset(q);
        std::vector<std::vector<std::int32_t>> fresh;
        for (int n = 0; n < 200; ++n) {
            const Wrench push{Vec3(0.0, 0.8, -0.5), Vec3(0.02, 0.01, 0.002)};
            tick(a, {}, true, push);
            tick(b, {}, true, push);
            fresh.emplace_back(a.encoderCounts().begin(), a.encoderCounts().end());
            for (std::size_t axis = 0; axis < 5; ++axis) {
                QVERIFY(std::abs(a.motorAngles()[static_cast<int>(axis)] -
                                 a.encoderCounts()[axis] * p.resolution[axis]) <=
                        0.5 * p.resolution[axis] * (1 + 1e-9));
                if (n >= 3)
                    QCOMPARE(b.encoderCounts()[axis], fresh[static_cast<std::size_t>(n - 3)][axis]);
            }
        }
        QVERIFY(fresh.back() != fresh.front());
    }

    void endStopsHold() {
        FiveBarPlantParameters p;
        FiveBarPlant plant(p);
        plant.reset(at(Vec3(0.0, 0.0, 0.06), 0.6));
        for (int n = 0; n < 4000; ++n) {
            const double side = (n / 1000) % 2 == 0 ? 1.0 : -1.0;
            tick(plant, {}, true,
                 {side * Vec3(0.0, 4.0, 6.0),
                  plant.dynamics().joint().torque_D(side * Vec3(0.15, 0.15, 0.001))});
            for (int axis = 0; axis < 5; ++axis) {
                const auto i = static_cast<std::size_t>(axis);
                const double beyond =
                    plant.q()[axis] - std::clamp(plant.q()[axis], p.minimum[i], p.maximum[i]);
                QVERIFY2(std::abs(beyond) < (axis == 4 ? 0.1 : 0.05),
                         qPrintable(QString("axis %1: %2").arg(axis).arg(beyond)));
            }
            QVERIFY(plant.motion().p_DT.allFinite() && plant.motion().v_DT.norm() < 5.0);
        }
    }

    void sameInputsSameBits() {
        FiveBarPlant a{FiveBarPlantParameters{}}, b{FiveBarPlantParameters{}};
        for (FiveBarPlant* plant : {&a, &b}) {
            plant->reset(at(Vec3(0.0, 0.0, 0.06), 0.6));
            for (int n = 0; n < 300; ++n)
                tick(*plant, {0.1, -0.1, 0.02, 0.01, 0.001}, true,
                     {Vec3(0.0, 0.5, 0.2), Vec3(0.01, 0.0, 0.0)});
        }
        QVERIFY(a.q() == b.q() && a.rates() == b.rates() && a.motorAngles() == b.motorAngles());
    }
};

QTEST_APPLESS_MAIN(TestFiveBarPlant)
#include "test_five_bar_plant.moc"
