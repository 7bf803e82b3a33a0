// SPDX-License-Identifier: GPL-3.0-or-later
// What the drawn and the force sections have to do with what is felt: the first nothing, the second less than
// 1 %, everywhere.
#include "core/fp_environment.h"
#include "support/urethra_reference_forces.h"
#include "urethra_states.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {

constexpr double kSteepEdge_m = 0.0005; // steeper than content allows: less than half of the usual step

UrethraAnatomy steepStricture() {
    UrethraAnatomy anatomy = strictured();
    anatomy.changes[0].edge_m = kSteepEdge_m;
    anatomy.changes[0].length_m = 0.010;
    return anatomy;
}

/// The largest relative difference of force and of torque where they are more than 5 % of the largest.
struct Difference {
    double force = 0.0, torque = 0.0;
};

Difference differenceOf(const UrethraForces& usual, const chiron::testing::UrethraReferenceForces& finer,
                        double offset_m) {
    core::Random random(14);
    std::vector<EndoscopeMotion> motions;
    double force = 0.0, torque = 0.0;
    for (int n = 0; n < 6000; ++n) {
        motions.push_back(randomMotion(random, usual.centreline(), offset_m));
        const core::Wrench w = usual.respond(motions.back()).wrench_A;
        force = std::max(force, w.force.norm());
        torque = std::max(torque, w.torque.norm());
    }
    Difference most;
    for (const EndoscopeMotion& motion : motions) {
        const core::Wrench w = usual.respond(motion).wrench_A;
        const chiron::testing::ReferenceResponse r = finer.respond(motion);
        if (r.force.norm() > 0.05 * force)
            most.force = std::max(most.force, (w.force - r.force).norm() / r.force.norm());
        if (r.torque.norm() > 0.05 * torque)
            most.torque = std::max(most.torque, (w.torque - r.torque).norm() / r.torque.norm());
    }
    return most;
}

} // namespace

class TestUrethraForcesGrid : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void drawnSectionsDoNotMatter();
    void twiceAsManySectionsAndSprings_data();
    void twiceAsManySectionsAndSprings();
    void theOldGridWouldFail();
};

void TestUrethraForcesGrid::drawnSectionsDoNotMatter() {
    UrethraForceSettings drawnFiner;
    drawnFiner.basicSections = 52;
    const UrethraForces usual({}, {}), drawn({}, {}, drawnFiner);
    core::Random random(14);
    for (int n = 0; n < 20000; ++n) {
        const EndoscopeMotion motion = randomMotion(random, usual.centreline(), 0.004);
        const UrethraResponse a = usual.respond(motion), b = drawn.respond(motion);
        QVERIFY(a.wrench_A.force == b.wrench_A.force && a.wrench_A.torque == b.wrench_A.torque);
    }
}

void TestUrethraForcesGrid::twiceAsManySectionsAndSprings_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<int>("springs");
    for (const int springs : {16, 32}) {
        QTest::addRow("normal, %d springs", springs) << 0 << springs;
        QTest::addRow("stricture, %d springs", springs) << 1 << springs;
        QTest::addRow("steep stricture, %d springs", springs) << 2 << springs;
    }
}

// Locally: of the force that is felt there, wherever it is more than 5 % of the largest.
void TestUrethraForcesGrid::twiceAsManySectionsAndSprings() {
    QFETCH(int, which);
    QFETCH(int, springs);
    const UrethraAnatomy anatomy = which == 0   ? UrethraAnatomy{}
                                   : which == 1 ? strictured()
                                                : steepStricture();
    UrethraForceSettings halved;
    halved.maximumStep_m = (which == 2 ? kSteepEdge_m / 3.2 : UrethraForceSettings{}.maximumStep_m) / 2.0;
    const Difference d = differenceOf(
        UrethraForces(anatomy, {}),
        chiron::testing::UrethraReferenceForces(anatomy, {}, halved, static_cast<std::size_t>(springs)),
        0.004);
    QVERIFY2(d.force < 0.01 && d.torque < 0.01, qPrintable(QString("%1, %2").arg(d.force).arg(d.torque)));
}

// That the measure can tell: 2.5 mm, the grid of earlier versions, is not enough for 1 % of the local force.
void TestUrethraForcesGrid::theOldGridWouldFail() {
    UrethraForceSettings coarse;
    coarse.maximumStep_m = 0.0025;
    const Difference d =
        differenceOf(UrethraForces({}, {}, coarse), chiron::testing::UrethraReferenceForces({}, {}), 0.004);
    QVERIFY(d.force > 0.02);
}

QTEST_APPLESS_MAIN(TestUrethraForcesGrid)
#include "test_urethra_forces_grid.moc"
