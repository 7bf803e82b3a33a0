// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "five_bar_loop.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using core::Vec3;
using mechanisms::FiveBarDynamics;
using mechanisms::FiveBarKinematics;
using mechanisms::FiveBarPlantParameters;
using mechanisms::FiveBarVector;

namespace {

FiveBarVector at(const Vec3& p_D, double pitch = 0.2, double yaw = 0.0, double roll = 0.0) {
    return tests::fiveBarAt(p_D, {pitch, yaw, roll});
}

/// Kinetic energy by moving every body a little, by finite differences.
double kineticByDifferences(const FiveBarPlantParameters& p, const FiveBarVector& q,
                            const FiveBarVector& rates) {
    const double h = 1e-5;
    FiveBarDynamics before(p), after(p), here(p);
    before.place(q - h * rates);
    after.place(q + h * rates);
    here.place(q);
    const auto speed2 = [&](const auto& point) {
        return ((point(after) - point(before)) / (2.0 * h)).squaredNorm();
    };
    double kinetic = 0.0;
    for (std::size_t leg = 0; leg < 2; ++leg) {
        const core::Vec2 base(p.geometry.baseForward_m + (leg == 0 ? -1.0 : 1.0) * p.geometry.halfBase_m,
                              p.geometry.baseUp_m);
        for (int slice = 0; slice < 1000; ++slice) { // tubes, cut into slices
            const double s = (slice + 0.5) / 1000.0;
            kinetic += 0.5 * p.proximalMass_kg / 1000.0 * speed2([&](const FiveBarDynamics& d) {
                           return core::Vec2(base + s * (d.loop().elbow[leg] - base));
                       });
            kinetic += 0.5 * p.distalMass_kg / 1000.0 * speed2([&](const FiveBarDynamics& d) {
                           return core::Vec2(d.loop().elbow[leg] + s * (d.loop().tip - d.loop().elbow[leg]));
                       });
        }
    }
    kinetic += 0.5 * p.jointMass_kg * speed2([](const FiveBarDynamics& d) { return d.loop().tip; });
    kinetic += 0.5 * p.endoscopeMass_kg * speed2([&](const FiveBarDynamics& d) {
                   return Vec3(FiveBarKinematics::toD(d.loop().tip) -
                               p.centreOfMassBehindTip_m * d.joint().view_D());
               });
    const Vec3 w = here.joint().angularVelocity_D(rates.tail<3>());
    const double about = w.dot(here.joint().view_D());
    kinetic += 0.5 * (p.acrossInertia_kgm2 * (w.squaredNorm() - about * about) +
                      p.axialInertia_kgm2 * about * about);
    return kinetic;
}

} // namespace

class TestFiveBarDynamics : public QObject {
    Q_OBJECT
private slots:
    void inertiaIsThatOfEveryBody() {
        const FiveBarPlantParameters p;
        FiveBarDynamics dynamics(p);
        core::Random random(1);
        for (int n = 0; n < 20; ++n) {
            const FiveBarVector q =
                at(Vec3(0.0, random.uniform(-0.07, 0.06), random.uniform(0.0, 0.13)),
                   random.uniform(-0.5, 1.6), random.uniform(-0.5, 0.5), random.uniform(-3.0, 3.0));
            FiveBarVector rates;
            rates << random.normal(), random.normal(), random.normal(), random.normal(), random.normal();
            dynamics.place(q);
            const double kinetic = 0.5 * rates.dot(dynamics.inertia() * rates);
            const double expected = kineticByDifferences(p, q, rates);
            QVERIFY2(std::abs(kinetic - expected) < 2e-6 * expected,
                     qPrintable(QString("%1 %2").arg(kinetic, 0, 'g', 12).arg(expected, 0, 'g', 12)));
            const FiveBarVector b = dynamics.inertia() * rates;
            QVERIFY((FiveBarDynamics::solve(dynamics.inertia(), b) - rates).norm() < 1e-10 * rates.norm());
        }
    }

    void gravityIsTheSlopeOfThePotential() {
        FiveBarDynamics dynamics{FiveBarPlantParameters{}};
        const FiveBarVector q = at(Vec3(0.0, 0.01, 0.05), 0.7, 0.3, 1.0);
        dynamics.place(q);
        const FiveBarVector g = dynamics.gravity();
        for (int axis = 0; axis < 5; ++axis) {
            const FiveBarVector by = 1e-6 * FiveBarVector::Unit(axis);
            dynamics.place(q + by);
            const double up = dynamics.potential_J();
            dynamics.place(q - by);
            QVERIFY(std::abs((up - dynamics.potential_J()) / 2e-6 - g[axis]) < 1e-8);
        }
    }

    /// About the device of models.md §4 at the tip, in every direction and place.
    void tipFeelsLight() {
        FiveBarDynamics dynamics{FiveBarPlantParameters{}};
        const FiveBarPlantParameters p;
        double lightest = 10.0, heaviest = 0.0;
        for (double y : {-0.075, 0.0, 0.065})
            for (double z : {-0.02, 0.06, 0.135})
                for (double pitch : {0.0, 0.6, 1.15}) {
                    const FiveBarVector q = at(Vec3(0.0, y, z), pitch);
                    dynamics.place(q);
                    mechanisms::FiveBarMatrix m = dynamics.inertia();
                    for (int axis = 0; axis < 5; ++axis)
                        m(axis, axis) += p.rotorInertia[static_cast<std::size_t>(axis)];
                    for (int n = 0; n < 12; ++n) {
                        const double a = core::radFromDeg(15.0 * n);
                        const FiveBarVector tau =
                            dynamics.efforts({Vec3(0.0, std::cos(a), std::sin(a)), Vec3::Zero()});
                        const double mass = 1.0 / tau.dot(FiveBarDynamics::solve(m, tau));
                        lightest = std::min(lightest, mass);
                        heaviest = std::max(heaviest, mass);
                    }
                }
        qInfo("mass at the tip %.3f..%.3f kg", lightest, heaviest);
        QVERIFY(lightest > 0.08 && heaviest < 0.28);
    }
};

QTEST_APPLESS_MAIN(TestFiveBarDynamics)
#include "test_five_bar_dynamics.moc"
