// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"

#include <QtTest>
#include <array>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;

namespace {

SphereApexParameters varied() {
    SphereApexParameters p;
    p.stiffnessLow_N_per_m = 300.0;
    p.stiffnessHigh_N_per_m = 900.0;
    p.stiffnessVariation = 0.3;
    p.frictionLow = 0.1;
    p.frictionHigh = 0.5;
    p.dimpleDepth_m = 0.001;
    p.trials = 32;
    return p;
}

} // namespace

class TestSphereApexPlan : public QObject {
    Q_OBJECT
private slots:
    void centresAreUniformInTheDisc();
    void allOfTheSphereIsInsideTheWorkspace();
    void drawsStayInTheirRanges();
    void sameSeedSamePlanOtherSeedOther();
    void centresDoNotDependOnOtherSettings();
    void dimpleSitsAtItsOffset();
    void contactTakesWhatWasPlanned();
};

// 32,000 centres over 80 cells of equal area (10 rings × 8 sectors): chi-squared with 79 degrees of freedom
// has mean 79 and SD sqrt(158) = 12.6; 136 is 4.5 SD up. Uniform in radius instead of area would give
// thousands.
void TestSphereApexPlan::centresAreUniformInTheDisc() {
    std::array<int, 80> cells{};
    const SphereApexParameters parameters = varied();
    for (std::uint64_t seed = 1; seed <= 1000; ++seed)
        for (const auto& trial : planSphereApexTrials(parameters, seed)) {
            const double area = trial.centre_m.squaredNorm() / (0.040 * 0.040);
            const double turn = std::atan2(trial.centre_m.y(), trial.centre_m.x()) / (2.0 * core::kPi) + 0.5;
            QVERIFY(area < 1.0);
            ++cells[std::min<std::size_t>(9, static_cast<std::size_t>(area * 10)) * 8 +
                    std::min<std::size_t>(7, static_cast<std::size_t>(turn * 8))];
        }
    double chiSquared = 0.0;
    for (const int seen : cells)
        chiSquared += (seen - 400.0) * (seen - 400.0) / 400.0;
    QVERIFY2(chiSquared < 136.0, qPrintable(QString::number(chiSquared)));
    QVERIFY(chiSquared > 36.0); // nor suspiciously even (3.4 SD down)
}

void TestSphereApexPlan::allOfTheSphereIsInsideTheWorkspace() {
    SphereApexParameters tight = varied();
    tight.workspaceRadius_m = 0.045; // leaves 25 mm for the centres, less than the disc
    double farthest = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
        for (const auto& trial : planSphereApexTrials(tight, seed)) {
            QVERIFY(trial.centre_m.norm() + tight.radius_m <= tight.workspaceRadius_m + 1e-15);
            farthest = std::max(farthest, trial.centre_m.norm());
        }
    QVERIFY(farthest > 0.0249);
    tight.workspaceRadius_m = 0.010; // no room: the middle
    for (const auto& trial : planSphereApexTrials(tight, 1))
        QCOMPARE(trial.centre_m.norm(), 0.0);
}

void TestSphereApexPlan::drawsStayInTheirRanges() {
    double softest = 1e9;
    double stiffest = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
        for (const auto& trial : planSphereApexTrials(varied(), seed)) {
            softest = std::min(softest, trial.stiffness_N_per_m);
            stiffest = std::max(stiffest, trial.stiffness_N_per_m);
            QVERIFY(trial.friction >= 0.1 && trial.friction < 0.5);
        }
    QVERIFY(softest >= 300.0 && softest < 303.0);
    QVERIFY(stiffest < 900.0 && stiffest > 897.0);
    for (const auto& trial : planSphereApexTrials(SphereApexParameters{}, 5)) { // equal ends fix the value
        QCOMPARE(trial.stiffness_N_per_m, 500.0);
        QCOMPARE(trial.friction, 0.0);
    }
}

void TestSphereApexPlan::sameSeedSamePlanOtherSeedOther() {
    const auto a = planSphereApexTrials(varied(), 17);
    const auto b = planSphereApexTrials(varied(), 17);
    const auto c = planSphereApexTrials(varied(), 18);
    QCOMPARE(a.size(), std::size_t{32});
    for (std::size_t i = 0; i < a.size(); ++i) {
        QCOMPARE(a[i].centre_m, b[i].centre_m);
        QCOMPARE(a[i].stiffness_N_per_m, b[i].stiffness_N_per_m);
        QCOMPARE(a[i].phase_rad, b[i].phase_rad);
        QVERIFY(a[i].centre_m != c[i].centre_m);
        QVERIFY(a[i].stiffness_N_per_m != c[i].stiffness_N_per_m);
        QVERIFY(i == 0 || a[i].centre_m != a[i - 1].centre_m);
    }
}

void TestSphereApexPlan::centresDoNotDependOnOtherSettings() {
    SphereApexParameters plain;
    plain.trials = 10;
    const auto a = planSphereApexTrials(plain, 3);
    const auto b = planSphereApexTrials(varied(), 3);
    for (std::size_t i = 0; i < a.size(); ++i)
        QCOMPARE(a[i].centre_m, b[i].centre_m);
}

void TestSphereApexPlan::dimpleSitsAtItsOffset() {
    for (const auto& trial : planSphereApexTrials(varied(), 3))
        QVERIFY(std::abs((trial.dimpleCentre_m - trial.centre_m).norm() - 0.010) < 1e-15);
}

void TestSphereApexPlan::contactTakesWhatWasPlanned() {
    const SphereApexParameters parameters = varied();
    const SphereApexTrial trial = planSphereApexTrials(parameters, 3)[4];
    const auto contact = sphereApexContact(parameters, trial);
    QCOMPARE(contact.surface.centre_m, trial.centre_m);
    QCOMPARE(contact.surface.radius_m, parameters.radius_m);
    QCOMPARE(contact.stiffness.base_N_per_m, trial.stiffness_N_per_m);
    QCOMPARE(contact.stiffness.variation, 0.3);
    QCOMPARE(contact.stiffness.phase_rad, trial.phase_rad);
    QCOMPARE(contact.friction, trial.friction);
    QCOMPARE(contact.dimple.centre_m, trial.dimpleCentre_m);
    QCOMPARE(contact.dimple.depth_m, 0.001);
    QCOMPARE(contact.damping_Ns_per_m, parameters.damping_Ns_per_m);
    QCOMPARE(contact.bristleStiffness_N_per_m, parameters.bristleStiffness_N_per_m);
}

QTEST_APPLESS_MAIN(TestSphereApexPlan)
#include "test_sphere_apex_plan.moc"
