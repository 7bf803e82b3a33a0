// SPDX-License-Identifier: GPL-3.0-or-later
// Tholey's method recovers what the simulated plant was made with, which it is not told.
#include "mechanisms/friction_identification.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::mechanisms;

class TestFrictionIdentification : public QObject {
    Q_OBJECT
private slots:
    void recoversThePlantsFriction_data() {
        QTest::addColumn<double>("more"); // times the usual friction
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("d");
        QTest::addColumn<bool>("feedForward");
        QTest::newRow("as it is") << 1.0 << 0.0 << 0.18 << true;
        QTest::newRow("leaning and far out") << 1.0 << 0.3 << 0.24 << true;
        QTest::newRow("twice the friction") << 2.0 << -0.2 << 0.16 << true;
        QTest::newRow("weight not carried")
            << 1.0 << 0.2 << 0.20 << false; // it cancels between there and back
    }
    void recoversThePlantsFriction() {
        QFETCH(double, more);
        QFETCH(double, h);
        QFETCH(double, d);
        QFETCH(bool, feedForward);
        GimbalPlantParameters parameters;
        parameters.gravityFeedForward = feedForward;
        for (LugreParameters& friction : parameters.friction) {
            friction.coulomb *= more;
            friction.viscous *= more;
        }
        GimbalPlant plant(parameters);
        const auto found = identifyFriction(plant, {h, 0.1, 0.0, d});
        QVERIFY2(found, found ? "" : found.error().message.c_str());
        QVERIFY(!(*found)[2]); // roll has no motor
        for (const std::size_t axis : {std::size_t{0}, std::size_t{1}, std::size_t{3}}) {
            const LugreParameters& truth = parameters.friction[axis];
            QVERIFY((*found)[axis].has_value());
            const AxisFriction& friction = *(*found)[axis];
            qInfo("axis %zu: Coulomb %.5f (made with %.5f), viscous %.5f (%.5f)", axis, friction.coulomb,
                  truth.coulomb, friction.viscous, truth.viscous);
            QVERIFY(std::abs(friction.coulomb / truth.coulomb - 1.0) < 0.10);
            QVERIFY(std::abs(friction.viscous / truth.viscous - 1.0) < 0.20);
        }
        QCOMPARE(plant.q().h, h); // left where it was asked to be
        QCOMPARE(plant.rates(), GimbalVector(GimbalVector::Zero()));
    }

    void aPlantWithoutFrictionHasNone() {
        GimbalPlantParameters parameters;
        for (LugreParameters& friction : parameters.friction)
            friction = {};
        GimbalPlant plant(parameters);
        const auto found = identifyFriction(plant, {0.0, 0.0, 0.0, 0.18});
        QVERIFY(found);
        for (const std::size_t axis : {std::size_t{0}, std::size_t{1}, std::size_t{3}})
            QVERIFY(std::abs((*found)[axis]->coulomb) <
                    0.02 * GimbalPlantParameters{}.friction[axis].coulomb);
    }

    void theSameSweepGivesTheSameBits() {
        GimbalPlant a{GimbalPlantParameters{}}, b{GimbalPlantParameters{}};
        const auto first = identifyFriction(a, {0.1, 0.0, 0.0, 0.18});
        const auto second = identifyFriction(b, {0.1, 0.0, 0.0, 0.18});
        QVERIFY(first && second);
        QCOMPARE((*first)[0]->coulomb, (*second)[0]->coulomb);
        QCOMPARE((*first)[3]->viscous, (*second)[3]->viscous);
    }

    void refusals() {
        GimbalPlant plant{GimbalPlantParameters{}};
        const GimbalCoordinates middle{0.0, 0.0, 0.0, 0.18};
        QVERIFY(!identifyFriction(plant, middle, {.slow = 0.0}));
        QVERIFY(!identifyFriction(plant, middle, {.slow = 0.2, .fast = 0.1}));
        QVERIFY(!identifyFriction(plant, middle, {.settled = 1.0}));
        const auto tooFar = identifyFriction(plant, {0.75, 0.0, 0.0, 0.18});
        QVERIFY(!tooFar && tooFar.error().code == core::ErrorCode::badInput);
        GimbalPlantParameters stuck;
        stuck.friction[0].coulomb = 2.0; // more than the motor gives
        GimbalPlant weak(stuck);
        const auto beyond = identifyFriction(weak, middle);
        QVERIFY(!beyond && beyond.error().code == core::ErrorCode::doesNotHold);
        QVERIFY(beyond.error().message.find("axis 0") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestFrictionIdentification)
#include "test_friction_identification.moc"
