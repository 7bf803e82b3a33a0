// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "simulation/palpation/surface_map.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace chiron;
using core::Vec2;
using simulation::SurfaceMap;

namespace {

constexpr int kCells = SurfaceMap::kColumns * SurfaceMap::kRows;

/// A direct implementation of the definition: every press is checked against every cell.
struct PlainMap {
    Vec2 half_m;
    double radius_m, cover_N;
    std::vector<float> force_N = std::vector<float>(kCells, 0.0F);

    void press(const SurfaceMap& map, const Vec2& p_m, double normal_N) {
        for (int row = 0; row < SurfaceMap::kRows; ++row)
            for (int column = 0; column < SurfaceMap::kColumns; ++column)
                if ((map.middle_m(column, row) - p_m).norm() <= radius_m) {
                    float& kept = force_N[static_cast<std::size_t>(row * SurfaceMap::kColumns + column)];
                    kept = std::max(kept, static_cast<float>(normal_N));
                }
    }
    double coverage() const {
        return static_cast<double>(
                   std::count_if(force_N.begin(), force_N.end(),
                                 [&](float f) { return static_cast<double>(f) >= cover_N; })) /
               kCells;
    }
    bool isIn(const SurfaceMap& map) const {
        for (int row = 0; row < SurfaceMap::kRows; ++row)
            for (int column = 0; column < SurfaceMap::kColumns; ++column)
                if (map.force_N(column, row) !=
                    static_cast<double>(
                        force_N[static_cast<std::size_t>(row * SurfaceMap::kColumns + column)]))
                    return false;
        return map.coverage() == coverage();
    }
};

} // namespace

/// Compares the map of presses with a direct implementation of its definition.
class TestSurfaceMap : public QObject {
    Q_OBJECT
private slots:
    void cellsFillTheArea();
    void everyPressIsWhereItWas_data();
    void everyPressIsWhereItWas();
    void reachesEveryBorderCell();
    void aStepIsAChange();
    void whatIsNoPressChangesNothing();
};

void TestSurfaceMap::cellsFillTheArea() {
    const SurfaceMap map({0.048, 0.024}, 0.004, 0.5);
    QVERIFY((map.middle_m(0, 0) - Vec2(-0.047, -0.0235)).norm() < 1e-12);
    QVERIFY((map.middle_m(SurfaceMap::kColumns - 1, SurfaceMap::kRows - 1) - Vec2(0.047, 0.0235)).norm() <
            1e-12);
}

void TestSurfaceMap::everyPressIsWhereItWas_data() {
    QTest::addColumn<double>("radius_m");
    QTest::newRow("a pad over several cells") << 0.0045;
    QTest::newRow("a pad smaller than a cell") << 0.0004;
    QTest::newRow("a pad larger than the area") << 0.09;
}

void TestSurfaceMap::everyPressIsWhereItWas() {
    QFETCH(double, radius_m);
    const Vec2 half(0.04, 0.03);
    SurfaceMap map(half, radius_m, 0.5);
    PlainMap plain{half, radius_m, 0.5};
    auto random = core::Random::stream(11, "presses");
    for (int i = 0; i < 200; ++i) {
        // every second press lies within the area, the others may lie beside it
        const double beyond = i % 2 ? 1.0 : 1.3;
        const Vec2 p(beyond * half.x() * random.uniform(-1.0, 1.0),
                     beyond * half.y() * random.uniform(-1.0, 1.0));
        const double force = random.uniform(0.01, 1.0);
        map.press(p, force);
        plain.press(map, p, force);
        QVERIFY2(plain.isIn(map), qPrintable(QStringLiteral("press %1").arg(i)));
    }
    map.clear();
    QVERIFY((PlainMap{half, radius_m, 0.5}.isIn(map)));
}

/// A pad smaller than a cell, pressed at the centre of a border cell, marks that cell alone.
void TestSurfaceMap::reachesEveryBorderCell() {
    const Vec2 half(0.04, 0.03);
    for (int row : {0, 1, SurfaceMap::kRows - 2, SurfaceMap::kRows - 1})
        for (int column : {0, 1, SurfaceMap::kColumns - 2, SurfaceMap::kColumns - 1}) {
            SurfaceMap map(half, 0.0001, 0.5);
            map.press(map.middle_m(column, row), 0.5);
            QVERIFY(map.covered(column, row)); // exactly the covering force is enough
            QCOMPARE(map.coverage(), 1.0 / kCells);
        }
}

void TestSurfaceMap::aStepIsAChange() {
    SurfaceMap map({0.04, 0.04}, 0.005, 0.5);
    const std::uint32_t before = map.step();
    map.press({0.0, 0.0}, 0.3);
    QCOMPARE(map.step(), before + 1);
    map.press({0.0, 0.0}, 0.3); // no harder than before
    map.press({0.0, 0.0}, 0.2);
    map.press({1.0, 0.0}, 0.9); // beside the area
    QCOMPARE(map.step(), before + 1);
    QCOMPARE(map.coverage(), 0.0); // pressed too softly to count as searched
    map.press({0.0, 0.0}, 0.6);
    QCOMPARE(map.step(), before + 2);
    QVERIFY(map.coverage() > 0.0);
    map.clear();
    QCOMPARE(map.step(), before + 3);
}

void TestSurfaceMap::whatIsNoPressChangesNothing() {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                     kInf = std::numeric_limits<double>::infinity();
    SurfaceMap map({0.04, 0.04}, 0.005, 0.5);
    for (const Vec2& p : {Vec2(kNan, 0.0), Vec2(0.0, kInf)})
        map.press(p, 1.0);
    for (const double force : {0.0, -1.0, kNan})
        map.press({0.0, 0.0}, force);
    for (const double far : {1e300, -1e300})
        map.press({far, far}, 1.0);
    QCOMPARE(map.step(), 0U);
    QCOMPARE(map.coverage(), 0.0);
}

QTEST_GUILESS_MAIN(TestSurfaceMap)
#include "test_surface_map.moc"
