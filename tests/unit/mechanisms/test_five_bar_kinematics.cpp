// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "mechanisms/five_bar_kinematics.h"
#include "mechanisms/five_bar_plant_parameters.h"
#include "mechanisms/mechanism_laws.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

using namespace chiron;
using core::Vec2;
using core::Vec3;
using mechanisms::FiveBarKinematics;
using mechanisms::FiveBarLoop;

namespace {

/// What urethra insertion needs: from 30 mm before the entrance to 20 mm beyond the bladder neck, with room
/// around.
constexpr double kMinY = -0.075, kMaxY = 0.065, kMinZ = -0.020, kMaxZ = 0.135;

template <class Visit> void overTheWorkspace(Visit visit) {
    for (int i = 0; i <= 70; ++i)
        for (int k = 0; k <= 77; ++k)
            visit(Vec3(0.0, kMinY + (kMaxY - kMinY) * i / 70.0, kMinZ + (kMaxZ - kMinZ) * k / 77.0));
}

} // namespace

class TestFiveBarKinematics : public QObject {
    Q_OBJECT
private slots:
    void linksKeepTheirLengths() {
        const FiveBarKinematics linkage;
        core::Random random(1);
        for (int n = 0; n < 1000; ++n) {
            const FiveBarLoop loop = linkage.loop(random.uniform(1.5, 3.4), random.uniform(-0.3, 1.6));
            QVERIFY(loop.closed);
            for (std::size_t i = 0; i < 2; ++i) {
                const Vec2 base(linkage.geometry().baseForward_m +
                                    (i == 0 ? -1.0 : 1.0) * linkage.geometry().halfBase_m,
                                linkage.geometry().baseUp_m);
                QVERIFY(std::abs((loop.elbow[i] - base).norm() - linkage.geometry().proximal_m) < 1e-14);
                QVERIFY(std::abs((loop.tip - loop.elbow[i]).norm() - linkage.geometry().distal_m) < 1e-14);
            }
        }
    }

    /// P1's axes: X_V into the patient is +y_D, Y_V up is +z_D, Z_V is x_D; right-handed, and the tip stays
    /// in the plane.
    void vendorAxesBecomeD() {
        QVERIFY(FiveBarKinematics::toD(Vec2(1.0, 2.0)) == Vec3(0.0, 1.0, 2.0));
        QVERIFY(FiveBarKinematics::toPlane(Vec3(7.0, 1.0, 2.0)) == Vec2(1.0, 2.0));
        QVERIFY(FiveBarKinematics::toD(Vec2::UnitX()).cross(FiveBarKinematics::toD(Vec2::UnitY())) ==
                Vec3::UnitX());
        const FiveBarKinematics linkage;
        const auto theta = linkage.inverse(Vec3(0.0, -0.069, 0.0));
        QVERIFY(theta.has_value());
        QVERIFY((linkage.tip_D((*theta)[0], (*theta)[1]) - Vec3(0.0, -0.069, 0.0)).norm() < 1e-13);
        // Both base angles less: both elbows go clockwise, towards +y: so does the tip.
        QVERIFY(linkage.tip_D((*theta)[0] - 0.05, (*theta)[1] - 0.05).y() > -0.069);
    }

    void inverseUndoesForward() {
        const FiveBarKinematics linkage;
        overTheWorkspace([&](const Vec3& p) {
            const auto theta = linkage.inverse(p);
            QVERIFY(theta.has_value());
            QVERIFY((linkage.tip_D((*theta)[0], (*theta)[1]) - p).norm() < 1e-12);
        });
    }

    void inverseRefusesWhatItCannotReach() {
        const FiveBarKinematics linkage;
        QVERIFY(!linkage.inverse(Vec3(0.0, 0.0, 0.5)));      // too far
        QVERIFY(!linkage.inverse(Vec3(0.0, 0.055, -0.175))); // on a base joint
        QVERIFY(!linkage.inverse(Vec3(0.0, 0.0, -0.45)));    // mirrored: the loop would hang down
        const auto nan = linkage.inverse(Vec3(0.0, std::nan(""), 0.0));
        QVERIFY(!nan && nan.error().code == core::ErrorCode::badInput);
    }

    void jacobianMatchesFiniteDifferences() {
        const FiveBarKinematics linkage;
        double worst = 0.0;
        overTheWorkspace([&](const Vec3& p) {
            const auto t = *linkage.inverse(p);
            const FiveBarLoop loop = linkage.loop(t[0], t[1]);
            const double h = 1e-6;
            const Vec2 first =
                (linkage.loop(t[0] + h, t[1]).tip - linkage.loop(t[0] - h, t[1]).tip) / (2.0 * h);
            const Vec2 second =
                (linkage.loop(t[0], t[1] + h).tip - linkage.loop(t[0], t[1] - h).tip) / (2.0 * h);
            worst = std::max(
                {worst, (first - loop.jacobian.col(0)).norm(), (second - loop.jacobian.col(1)).norm()});
        });
        QVERIFY2(worst < 1e-9, qPrintable(QString::number(worst)));
    }

    /// The acceleration that a turning linkage has without accelerating its base angles.
    void biasAccelerationMatchesFiniteDifferences() {
        const FiveBarKinematics linkage;
        core::Random random(2);
        for (int n = 0; n < 200; ++n) {
            const Vec2 at(random.uniform(1.7, 3.2), random.uniform(-0.1, 1.4));
            const Vec2 rates(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0));
            const auto tip = [&](double t) {
                return linkage.loop(at[0] + rates[0] * t, at[1] + rates[1] * t).tip;
            };
            const double h = 1e-4;
            const Vec2 second = (tip(h) - 2.0 * tip(0.0) + tip(-h)) / (h * h);
            const Vec2 made = linkage.loop(at[0], at[1]).biasAcceleration(rates);
            QVERIFY2((second - made).norm() < 1e-5 * (1.0 + made.norm()),
                     qPrintable(QString::number((second - made).norm())));
        }
    }

    void effortsConservePowerAndGiveTheForceBack() {
        const FiveBarKinematics linkage;
        core::Random random(3);
        for (int n = 0; n < 500; ++n) {
            const FiveBarLoop loop = linkage.loop(random.uniform(1.7, 3.2), random.uniform(-0.1, 1.4));
            const Vec3 force(random.normal(), random.normal(), random.normal());
            const Vec2 rates(random.normal(), random.normal());
            const Vec2 tau = FiveBarKinematics::efforts(loop, force);
            QVERIFY(std::abs(tau.dot(rates) - force.dot(FiveBarKinematics::toD(loop.jacobian * rates))) <
                    1e-13);
            // No motor pushes out of the plane: that part of the force is lost.
            QVERIFY((FiveBarKinematics::force_D(loop, tau) - Vec3(0.0, force.y(), force.z())).norm() < 1e-12);
        }
    }

    /// Away from every singularity: det A = 0 (distal links in line) and B_ii = 0 (a leg stretched or
    /// folded).
    void workspaceIsFarFromSingular() {
        const FiveBarKinematics linkage;
        const double l1 = linkage.geometry().proximal_m, l2 = linkage.geometry().distal_m;
        double condition = 0.0, inLine = 1.0, stretched = 1.0, longest = 0.0, shortest = 1.0;
        overTheWorkspace([&](const Vec3& p) {
            const auto t = *linkage.inverse(p);
            const FiveBarLoop loop = linkage.loop(t[0], t[1]);
            condition = std::max(condition, FiveBarKinematics::conditionNumber(loop));
            inLine = std::min(inLine, loop.determinant / (l2 * l2));
            for (std::size_t i = 0; i < 2; ++i) {
                const auto leg = static_cast<int>(i);
                stretched = std::min(stretched,
                                     std::abs((loop.tip - loop.elbow[i]).dot(loop.tangent[i])) / (l1 * l2));
                longest = std::max(longest, loop.jacobian.col(leg).norm());
                shortest = std::min(shortest, loop.jacobian.col(leg).norm());
            }
        });
        qInfo("condition %.3f, det A/l2^2 %.3f, |sin elbow| %.3f, |j| %.4f..%.4f m/rad", condition, inLine,
              stretched, shortest, longest);
        QVERIFY(condition < 1.85);
        QVERIFY(inLine > 0.8 && stretched > 0.65);
        // The motors' share for rendering is 4.5 N in the weakest direction of the weakest pose, not more
        // than 1 % above.
        const mechanisms::FiveBarPlantParameters plant;
        QVERIFY(plant.renderLimit[0] >= 4.5 * longest && plant.renderLimit[0] <= 4.5 * longest * 1.015);
        QVERIFY(plant.renderLimit[1] == plant.renderLimit[0]);
        // A count at the tip: no worse than the count that the tissue's friction is regularised for.
        QVERIFY(plant.resolution[0] * longest < 25e-6);
    }

    void evaluatedTablesAgree() {
        const auto laws = mechanisms::evaluateLaws();
        const auto evaluate = [&](std::string_view id, const std::vector<double>& in) {
            for (const auto& law : laws) {
                if (law.id != id || law.inputs.size() != in.size())
                    continue;
                std::vector<double> parameters, out(law.outputs.size(), std::nan(""));
                for (const auto& parameter : law.parameters)
                    parameters.push_back(parameter.defaultValue);
                law.evaluate(parameters, in, out);
                return out;
            }
            return std::vector<double>{};
        };
        const FiveBarLoop loop = FiveBarKinematics().loop(2.5, 0.6);
        const auto pose = evaluate("five_bar_pose", {2.5, 0.6});
        QCOMPARE(pose.size(), std::size_t{8});
        QVERIFY(pose[0] == loop.tip.x() && pose[1] == loop.tip.y() && pose[3] == loop.jacobian(0, 1));
        QVERIFY(pose[4] == loop.jacobian(1, 0) && pose[6] == loop.determinant);
        QVERIFY(pose[7] == FiveBarKinematics::conditionNumber(loop));
        const auto efforts =
            evaluate("five_bar_efforts", {2.5, 0.6, 0.0, 0.0, 9.0, 1.0, 2.0, 0.1, 0.01, 0.05});
        QCOMPARE(efforts.size(), std::size_t{5});
        const Vec2 tau = loop.jacobian.transpose() * Vec2(1.0, 2.0);
        QVERIFY(efforts[0] == tau[0] && efforts[1] == tau[1]);
        // Level and straight: pitch about x, yaw about z, roll about y of D.
        QVERIFY(efforts[2] == 0.1 && std::abs(efforts[3] - 0.05) < 1e-15 &&
                std::abs(efforts[4] - 0.01) < 1e-15);
    }

    /// Wherever the stops let the base angles go the linkage is one and the same assembly, so that counts
    /// mean one pose.
    void oneAssemblyModeWithinTheStops() {
        const FiveBarKinematics linkage;
        const mechanisms::FiveBarPlantParameters plant;
        const double l1 = linkage.geometry().proximal_m, l2 = linkage.geometry().distal_m;
        for (int i = 0; i <= 120; ++i) {
            for (int k = 0; k <= 120; ++k) {
                const FiveBarLoop loop =
                    linkage.loop(plant.minimum[0] + (plant.maximum[0] - plant.minimum[0]) * i / 120.0,
                                 plant.minimum[1] + (plant.maximum[1] - plant.minimum[1]) * k / 120.0);
                QVERIFY(loop.closed);
                QVERIFY(loop.determinant / (l2 * l2) > 0.25);
                QVERIFY(loop.elbow[1].x() - loop.elbow[0].x() > 0.05);
                QVERIFY((loop.tip - loop.elbow[0]).dot(loop.tangent[0]) / (l1 * l2) < 0.0);
                QVERIFY((loop.tip - loop.elbow[1]).dot(loop.tangent[1]) / (l1 * l2) > 0.0);
            }
        }
        overTheWorkspace([&](const Vec3& p) {
            const auto t = *linkage.inverse(p);
            for (std::size_t i = 0; i < 2; ++i)
                QVERIFY(t[i] > plant.minimum[i] + 0.05 && t[i] < plant.maximum[i] - 0.05);
        });
    }
};

QTEST_APPLESS_MAIN(TestFiveBarKinematics)
#include "test_five_bar_kinematics.moc"
