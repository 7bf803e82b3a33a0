// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "devices/drivers/simulated/gimbal_hprd_kinematics.h"
#include "devices/kinematics_catalogue.h"
#include "mechanisms/gimbal_kinematics.h"
#include "mechanisms/mechanism_laws.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <vector>

using namespace chiron;
using core::Vec3;
using mechanisms::GimbalCoordinates;
using mechanisms::GimbalKinematics;
using mechanisms::GimbalVector;
using mechanisms::PolarMap;

/// What others reach by id: the driver's kinematics and the evaluated laws.
class TestGimbalCatalogued : public QObject {
    Q_OBJECT
private slots:
    void driverKinematicsAgree();
    void driverKinematicsRefuseBadDescriptors();
    void catalogueMakesThem();
    void lawsAnswerWithTheirColumns();
};

namespace {

devices::DeviceDescriptor descriptor(double map) {
    devices::DeviceDescriptor d;
    d.kinematics = "gimbal_hprd";
    d.kinematicsParameters = {0.18, map};
    d.axes.resize(4);
    for (auto& axis : d.axes)
        axis.resolution = 1e-4;
    return d;
}

} // namespace

void TestGimbalCatalogued::driverKinematicsAgree() {
    auto exact = devices::GimbalHprdKinematics::create(descriptor(0.0));
    const auto published = devices::GimbalHprdKinematics::create(descriptor(1.0));
    QVERIFY(exact.has_value() && published.has_value());
    core::DeviceSample sample;
    sample.counts = {2500, -3000, 4000, 1900};
    const GimbalCoordinates q{0.25, -0.3, 0.4, 0.19};
    QVERIFY((exact->pose(sample).p_WT - GimbalKinematics(0.18).tip_D(q)).norm() < 1e-15);
    Vec3 v, w;
    exact->velocity(sample, {10.0, 20.0, 30.0, 40.0}, v, w);
    const Eigen::Matrix<double, 6, 1> twist =
        GimbalKinematics(0.18).jacobian_D(q) * GimbalVector(1e-3, 2e-3, 3e-3, 4e-3);
    QVERIFY((v - twist.head<3>()).norm() < 1e-15 && (w - twist.tail<3>()).norm() < 1e-15);
    const core::Wrench wrench{Vec3(1.0, 2.0, 3.0), Vec3::Zero()};
    const auto tau = GimbalKinematics::efforts(q, wrench, PolarMap::exact);
    const auto tauPublished = GimbalKinematics::efforts(q, wrench, PolarMap::asPublished);
    for (std::size_t axis = 0; axis < 4; ++axis) {
        QVERIFY(std::abs(exact->efforts(sample, wrench)[axis] - tau[static_cast<int>(axis)]) < 1e-14);
        QVERIFY(std::abs(published->efforts(sample, wrench)[axis] - tauPublished[static_cast<int>(axis)]) <
                1e-14);
    }
    QVERIFY((tau - tauPublished).norm() > 1e-3);
}

void TestGimbalCatalogued::driverKinematicsRefuseBadDescriptors() {
    auto bad = descriptor(0.0);
    bad.kinematics = "cartesian";
    QVERIFY(!devices::GimbalHprdKinematics::create(bad));
    bad = descriptor(2.0);
    QVERIFY(!devices::GimbalHprdKinematics::create(bad));
    bad = descriptor(0.0);
    bad.axes.pop_back();
    QVERIFY(!devices::GimbalHprdKinematics::create(bad));
    bad = descriptor(0.0);
    bad.axes[2].resolution = 0.0;
    QVERIFY(!devices::GimbalHprdKinematics::create(bad));
    bad = descriptor(0.0);
    bad.kinematicsParameters.clear();
    QVERIFY(!devices::GimbalHprdKinematics::create(bad));
}

void TestGimbalCatalogued::catalogueMakesThem() {
    const auto made = devices::makeKinematics(descriptor(0.0));
    QVERIFY(made.has_value());
    core::DeviceSample sample;
    sample.counts = {2500, -3000, 0, 1900};
    QVERIFY(((*made)->pose(sample).p_WT - GimbalKinematics(0.18).tip_D({0.25, -0.3, 0.0, 0.19})).norm() <
            1e-15);
}

void TestGimbalCatalogued::lawsAnswerWithTheirColumns() {
    const auto laws = mechanisms::evaluateLaws();
    QCOMPARE(laws.size(), std::size_t(4));
    for (const auto& law : laws) {
        std::vector<double> parameters;
        for (const auto& parameter : law.parameters)
            parameters.push_back(parameter.defaultValue);
        std::vector<double> in(law.inputs.size(), 0.2), out(law.outputs.size(), std::nan(""));
        law.evaluate(parameters, in, out);
        QVERIFY(std::all_of(out.begin(), out.end(), [](double x) { return std::isfinite(x); }));
    }
    const double angle = core::radFromDeg(30.0);
    const std::vector<double> parameters{0.18}, in{angle, angle, 1.0, 0.0, 0.0};
    std::vector<double> out(10);
    laws[0].evaluate(parameters, in, out);
    QVERIFY(std::abs(out[0] - std::cos(angle)) < 1e-15); // F_h = F_x cos h
    QVERIFY(std::abs(out[2] - std::sin(angle)) < 1e-15); // F_d = F_x sin h
    QVERIFY(std::abs(out[4] + std::sin(angle) * std::sin(angle)) < 1e-15);
    QVERIFY(std::abs(out[6] - 0.18 * std::cos(angle) * std::cos(angle)) < 1e-15);
}

QTEST_APPLESS_MAIN(TestGimbalCatalogued)
#include "test_gimbal_catalogued.moc"
