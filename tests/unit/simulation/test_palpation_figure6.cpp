// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "support/p3_figure6.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::tests;

namespace {
constexpr double kLimit = core::kPi / 6.0; // the plate's 30°

const Figure6Sample& mostOf(const std::vector<Figure6Sample>& all, double from_m, double to_m,
                            double Figure6Sample::*what) {
    const Figure6Sample* most = nullptr;
    for (const Figure6Sample& s : all)
        if (s.y_m >= from_m && s.y_m <= to_m && s.normalForce_N > 0.5 &&
            (most == nullptr || s.*what > most->*what))
            most = &s;
    if (most == nullptr)
        qFatal("nothing there");
    return *most;
}
} // namespace

// What P3's figure 6 shows: force and α along a stroke over a tumour, the larger angles cut at 30°.
class TestPalpationFigure6 : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void features();
    void noTumourNoFeatures();
};

void TestPalpationFigure6::features() {
    const Figure6 of;
    const auto samples = figure6(of);
    const double besides =
        std::atan(of.friction); // sliding over homogeneous tissue: μ, and B v/F of half a per mille
    const auto& before = mostOf(samples, -0.006, -0.0035, &Figure6Sample::lean_rad);
    QVERIFY2(std::abs(before.lean_rad - besides) < 1e-3, qPrintable(QString::number(before.lean_rad)));
    QVERIFY(!before.saturated && std::abs(before.normalForce_N - 650.0 * of.depth_m) < 1e-3);

    // Saturated at both flanks: α beyond 30°, the plate at 30°.
    for (const bool first : {true, false}) {
        const auto& flank = first ? mostOf(samples, -0.003, 0.0, &Figure6Sample::lean_rad)
                                  : mostOf(samples, 0.0, 0.003, &Figure6Sample::lean_rad);
        QVERIFY2(flank.lean_rad > kLimit && flank.saturated,
                 qPrintable(QString::number(flank.lean_rad * 57.2957795)));
        QVERIFY(std::abs(flank.shown_rad - kLimit) < 1e-9);
        QVERIFY(std::abs(flank.y_m) > 0.0005 && std::abs(flank.y_m) < of.tumourRadius_m);
        QVERIFY(first ? flank.lateral_N < 0.0
                      : flank.lateral_N > 0.0); // pushed back up to the tumour, on behind it
    }
    // Over the crown α is what it is beside the tumour, and the force is largest.
    const Figure6Sample* crown = &samples.front();
    for (const Figure6Sample& s : samples) {
        if (s.normalForce_N > 0.5 && std::abs(s.y_m) < std::abs(crown->y_m))
            crown = &s;
        QVERIFY(s.shown_rad <= kLimit + 1e-12 && (s.saturated == (s.lean_rad > kLimit)));
        QVERIFY(std::abs(s.normalForce_N - s.force_N * std::cos(s.lean_rad)) <
                2e-3); // eq. 3; under 50 mN the angle fades
    }
    QVERIFY2(std::abs(crown->lean_rad - besides) < 2e-3, qPrintable(QString::number(crown->lean_rad)));
    const auto& peak = mostOf(samples, -0.006, 0.006, &Figure6Sample::force_N);
    QVERIFY(std::abs(peak.y_m) < 1e-4);
    const double overlap = of.tumourRadius_m - (of.tumourDepth_m - of.depth_m);
    QVERIFY(std::abs(crown->normalForce_N - (650.0 * of.depth_m + of.tumourStiffness_N_per_m * overlap)) <
            1e-4);
    QVERIFY(peak.force_N < 4.5);
}

void TestPalpationFigure6::noTumourNoFeatures() {
    Figure6 of;
    of.tumourStiffness_N_per_m = 0.0;
    for (const Figure6Sample& s : figure6(of))
        QVERIFY(!s.saturated && s.lean_rad < std::atan(of.friction) + 1e-2 &&
                s.normalForce_N < 650.0 * of.depth_m + 0.01);
}

QTEST_APPLESS_MAIN(TestPalpationFigure6)
#include "test_palpation_figure6.moc"
