// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/driver_catalogue.h"
#include "devices/drivers/cartesian/cartesian_kinematics.h"
#include "devices/kinematics_catalogue.h"

#include "core/random.h"
#include "core/units.h"

#include <QtTest>

using namespace chiron;
using core::Mat3;
using core::Vec3;

namespace {
devices::DeviceDescriptor descriptor(int axes) {
    devices::DeviceDescriptor d;
    d.kinematics = "cartesian";
    d.jawResolution_rad = 1e-3;
    for (int i = 0; i < axes; ++i)
        d.axes.push_back({.id = "a" + std::to_string(i),
                          .unit = i < 3 ? devices::AxisUnit::metre : devices::AxisUnit::radian,
                          .resolution = i < 3 ? 1e-6 : 1e-7});
    return d;
}
core::DeviceSample sampleOf(const Vec3& p, const Vec3& r) {
    core::DeviceSample s;
    for (int i = 0; i < 3; ++i) {
        s.counts[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(std::lround(p[i] / 1e-6));
        s.counts[static_cast<std::size_t>(i) + 3] = static_cast<std::int32_t>(std::lround(r[i] / 1e-7));
    }
    return s;
}
} // namespace

class TestCartesianKinematics : public QObject {
    Q_OBJECT
private slots:
    void poseIsCountsTimesResolution() {
        const auto kinematics = devices::CartesianKinematics::create(descriptor(3));
        QVERIFY(kinematics.has_value());
        core::DeviceSample s = sampleOf({0.001, -0.002, 0.03}, Vec3::Zero());
        s.jawCounts = 250;
        const core::ToolState tool = kinematics->pose(s);
        QVERIFY((tool.p_WT - Vec3(0.001, -0.002, 0.03)).norm() < 1e-15);
        QCOMPARE(tool.q_WT.w(), 1.0);
        QCOMPARE(tool.jaw_rad, 0.25);
    }

    void aQuarterTurnAboutZ() {
        const auto kinematics = devices::CartesianKinematics::create(descriptor(6));
        const core::ToolState tool = kinematics->pose(sampleOf(Vec3::Zero(), {0.0, 0.0, core::kPi / 2.0}));
        QVERIFY((tool.q_WT * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-6);
        QVERIFY(std::abs(tool.q_WT.norm() - 1.0) < 1e-15);
    }

    /// w = J(r) ṙ against the orientation's own central difference: R(t+h) R(t-h)ᵀ = 1 + 2h [w]×.
    void angularVelocityMatchesTheOrientationsDerivative() {
        const auto kinematics = devices::CartesianKinematics::create(descriptor(6));
        core::Random random(5);
        for (int n = 0; n < 200; ++n) {
            const double size = n < 20 ? 1e-5 : 2.5; // the series' branch too
            const Vec3 r(random.uniform(-size, size), random.uniform(-size, size),
                         random.uniform(-size, size));
            const Vec3 rate(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            devices::AxisValues countRates{};
            for (int i = 0; i < 3; ++i)
                countRates[static_cast<std::size_t>(i) + 3] = rate[i] / 1e-7;
            Vec3 v;
            Vec3 w;
            kinematics->velocity(sampleOf(Vec3::Zero(), r), countRates, v, w);
            const double h = 1e-4;
            const auto turned = [](const Vec3& x) {
                return Mat3(Eigen::AngleAxisd(x.norm(), x.normalized()).toRotationMatrix());
            };
            const Mat3 delta = turned(r + h * rate) * turned(r - h * rate).transpose();
            const Vec3 expected =
                Vec3(delta(2, 1) - delta(1, 2), delta(0, 2) - delta(2, 0), delta(1, 0) - delta(0, 1)) /
                (4.0 * h);
            // Central difference: h² error; the grid of 1e-7 rad moves r by as much.
            QVERIFY2((w - expected).norm() < 2e-6, qPrintable(QString::number((w - expected).norm())));
            QVERIFY(v.isZero());
        }
    }

    void effortsConservePower() {
        const auto kinematics = devices::CartesianKinematics::create(descriptor(6));
        core::Random random(6);
        for (int n = 0; n < 200; ++n) {
            const core::DeviceSample s =
                sampleOf(Vec3::Zero(), {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)});
            const core::Wrench wrench{Vec3(random.normal(), random.normal(), random.normal()),
                                      Vec3(random.normal(), random.normal(), random.normal())};
            devices::AxisValues rates{};
            devices::AxisValues countRates{};
            for (std::size_t i = 0; i < 6; ++i) {
                rates[i] = random.normal();
                countRates[i] = rates[i] / (i < 3 ? 1e-6 : 1e-7);
            }
            Vec3 v;
            Vec3 w;
            kinematics->velocity(s, countRates, v, w);
            const devices::AxisValues efforts = kinematics->efforts(s, wrench);
            double joint = 0.0;
            for (std::size_t i = 0; i < 6; ++i)
                joint += efforts[i] * rates[i];
            QVERIFY(std::abs(joint - wrench.force.dot(v) - wrench.torque.dot(w)) < 1e-10);
        }
    }

    void badDescriptorsAreRefusedWithTheAxis() {
        QVERIFY(!devices::CartesianKinematics::create(descriptor(4)));
        auto d = descriptor(3);
        d.axes[1].resolution = 0.0;
        const auto flat = devices::CartesianKinematics::create(d);
        QVERIFY(!flat);
        QVERIFY(flat.error().message.find("a1") != std::string::npos);
        d = descriptor(3);
        d.axes[2].unit = devices::AxisUnit::radian;
        QVERIFY(!devices::CartesianKinematics::create(d));
        d = descriptor(3);
        d.axes[0].resolution = std::nan("");
        QVERIFY(!devices::CartesianKinematics::create(d));
    }

    void theCatalogueMakesWhatItKnowsAndNamesWhatItDoesNot() {
        const auto made = devices::makeKinematics(descriptor(3));
        QVERIFY(made.has_value());
        QVERIFY((*made)->pose(sampleOf({1e-3, 0, 0}, Vec3::Zero())).p_WT.x() == 1000 * 1e-6);
        auto d = descriptor(3);
        d.kinematics = "hovercraft";
        const auto unknown = devices::makeKinematics(d);
        QVERIFY(!unknown);
        QVERIFY(unknown.error().message.find("hovercraft") != std::string::npos);
    }

    void everyDriverIsListedOnceAndFound() {
        for (const devices::Driver* driver : devices::driverCatalogue()) {
            QVERIFY(!driver->title.empty() && !driver->needs.empty());
            QVERIFY(devices::findDriver(driver->id) == driver);
        }
        QVERIFY(devices::findDriver("keyboard_mouse") != nullptr);
        QVERIFY(devices::findDriver("replay") != nullptr);
        QVERIFY(devices::findDriver("simulated") != nullptr);
        QVERIFY(devices::findDriver("none") == nullptr);
    }
};

QTEST_APPLESS_MAIN(TestCartesianKinematics)
#include "test_cartesian_kinematics.moc"
