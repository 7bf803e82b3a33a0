// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/rotation_rates.h"

#include <QtTest>
#include <cmath>

using namespace chiron;

/// The left Jacobian of SO(3) is what the rotations along the way add up to: J(r) = ∫₀¹ exp(s r) ds.
class TestRotationRates : public QObject {
    Q_OBJECT
private slots:
    void isTheIntegralOfTheRotations_data();
    void isTheIntegralOfTheRotations();
};

void TestRotationRates::isTheIntegralOfTheRotations_data() {
    QTest::addColumn<double>("angle");
    for (const double angle : {0.0, 1e-9, 2e-5, 9.9e-5, 1.01e-4, 1e-3, 0.1, 1.0,
                               3.0}) // on both sides of where the series takes over
        QTest::addRow("%g rad", angle) << angle;
}

void TestRotationRates::isTheIntegralOfTheRotations() {
    QFETCH(double, angle);
    const core::Vec3 axis = core::Vec3(0.3, -0.5, 0.8).normalized();
    core::Mat3 sum = core::Mat3::Zero();      // Simpson's rule
    const int steps = angle > 0.01 ? 400 : 4; // more would add up what is rounded
    for (int i = 0; i <= steps; ++i) {
        const double weight = i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight * Eigen::AngleAxisd(angle * i / steps, axis).toRotationMatrix();
    }
    const core::Mat3 expected = sum / (3.0 * steps);
    const double worst = (devices::leftJacobian(angle * axis) - expected).cwiseAbs().maxCoeff();
    // Below where the series takes over nothing is cancelled; above, 1 - cos loses half of its digits.
    const double most = angle < 1e-4 ? 2e-15 : angle < 0.01 ? 2e-11 : 5e-11;
    QVERIFY2(worst < most, qPrintable(QString::number(worst)));
}

QTEST_GUILESS_MAIN(TestRotationRates)
#include "test_rotation_rates.moc"
