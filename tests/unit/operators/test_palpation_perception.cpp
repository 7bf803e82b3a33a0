// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "modules/exercises/palpation/operators/evidence_map.h"
#include "modules/exercises/palpation/operators/finger_senses.h"
#include "modules/exercises/palpation/operators/palpation_operator.h"
#include "modules/exercises/palpation/operators/search_path.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using namespace chiron::operators;
using core::Vec2;
using core::Vec3;

/// What a palpator's senses, its map of evidence and its ways over the search area do, each alone.
class TestPalpationPerception : public QObject {
    Q_OBJECT
private slots:
    void platformAndForceTellTheSame_data();
    void platformAndForceTellTheSame();
    void frictionInTheAirIsNoTouch();
    void noiseIsWhatItSays();
    void mapFindsWhereItIs();
    void mapOfNoiseStaysBelow();
    void mapTellsTwoApart();
    void leanAlonePointsAtIt();
    void whatIsFeltIsWeighedByItsNoise();
    void gridCoversTheArea();
    void twoFingersShareTheColumns();
    void spiralAndRandomStayInside();
    void badSettingsAreRefused();
};

namespace {

PalpationPerceptionSettings noiseless() {
    PalpationPerceptionSettings s;
    s.hand.visionNoiseSd_m = s.hand.forceWeberFraction = s.hand.forceFloorSd_N = s.hand.directionNoiseSd_rad =
        0.0;
    s.depthWeberFraction = s.memoryFraction = s.leanNoiseSd_rad = 0.0;
    return s;
}

/// One press of 300 ms: touch at the surface, then `depth_m` below it.
Press pressOnce(FingerSenses& senses, const mechanisms::HandPerception& deep, double depth_m, int number) {
    FingerOrder order;
    order.press = number;
    order.attendFrom_s = 0.1 + number;
    order.attendUntil_s = 0.4 + number;
    mechanisms::HandPerception seen = deep;
    const bool light = !deep.fingertip;
    for (int i = 0; i < 500; ++i) {
        seen.time_s = 0.001 * i + number;
        const double share = std::min(1.0, i / 50.0);
        seen.p_DT.z() = -share * depth_m;
        seen.pad.normalForce_N = share * deep.pad.normalForce_N;
        if (light)
            seen.f_T_D = share * deep.f_T_D;
        if (senses.feel(seen, order))
            return senses.press();
    }
    return {};
}

/// Presses on a grid over a square of ±40 mm, 8 mm apart, over lumps of models.md §3's shape, with normal
/// noise.
void pressGrid(EvidenceMap& map, const std::vector<Suspicion>& lumps, double stiffnessNoise, double leanNoise,
               std::uint64_t seed, bool flatStiffness = false) {
    core::Random random(seed);
    for (double x = -0.036; x < 0.037; x += 0.008)
        for (double y = -0.036; y < 0.037; y += 0.008) {
            Press press{{x, y}, 1.5, 0.006, 1.0, Vec2::Zero(), 0};
            for (const Suspicion& lump : lumps) {
                const Vec2 away = press.place_m - lump.place_m;
                const double w2 = lump.width_m * lump.width_m, q = 1.0 / (1.0 + away.squaredNorm() / w2);
                press.stiffness_N_per_m += flatStiffness ? 0.0 : lump.amplitude * q * q * q;
                press.lean_rad += lump.amplitude * 3.0 * press.depth_m / w2 * q * q * q * q * away;
            }
            press.stiffness_N_per_m *= 300.0 * (1.0 + stiffnessNoise * random.normal());
            press.lean_rad += leanNoise * Vec2(random.normal(), random.normal());
            map.add(press);
        }
}

Suspicion weighed(EvidenceMap& map) {
    map.begin();
    while (!map.advance(50)) {
    }
    return map.strongest();
}

} // namespace

void TestPalpationPerception::platformAndForceTellTheSame_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::newRow("along x") << 0.1 << 0.0;
    QTest::newRow("against y") << 0.0 << -0.2;
    QTest::newRow("askew") << -0.15 << 0.1;
}

// P3's platform shows the lean as pitch and roll; a device that pushes shows it as lateral force: the same is
// felt.
void TestPalpationPerception::platformAndForceTellTheSame() {
    QFETCH(double, x);
    QFETCH(double, y);
    mechanisms::HandPerception onPlatform;
    onPlatform.fingertip = true;
    onPlatform.pad = {1.5, -y, x}; // roll = + l·x, pitch = − l·y
    FingerSenses one(noiseless(), {}, {}, 1);
    const Press shown = pressOnce(one, onPlatform, 0.005, 1);
    devices::WorkspaceMapping left;
    left.leftHanded = true;
    onPlatform.pad.roll_rad = -x; // on the mirrored device
    FingerSenses mirror(noiseless(), {}, left, 1);
    const Press mirrored = pressOnce(mirror, onPlatform, 0.005, 1);
    QVERIFY((mirrored.lean_rad - Vec2(x, y)).norm() < 1e-9);
    mechanisms::HandPerception pushed;
    const double size = std::hypot(x, y);
    pushed.f_T_D = {1.5 * std::tan(size) * x / size, 1.5 * std::tan(size) * y / size, 1.5};
    FingerSenses other(noiseless(), {}, {}, 1);
    const Press felt = pressOnce(other, pushed, 0.005, 1);
    QVERIFY((shown.lean_rad - Vec2(x, y)).norm() < 1e-9);
    QVERIFY((felt.lean_rad - Vec2(x, y)).norm() < 1e-9);
    QVERIFY(std::abs(shown.force_N - 1.5) < 1e-9 && std::abs(felt.force_N - 1.5) < 1e-9);
    // It counts from where the finger felt something: 0.05 N of 1.5 N later than it touched, a tick at most.
    QVERIFY(shown.depth_m < 0.005 && shown.depth_m > 0.005 * (1.0 - 0.05 / 1.5) - 0.00011);
}

// A held instrument answers the hand before it touches (friction), and the grip gives way: how far its tip
// went into the tissue is told all the same.
void TestPalpationPerception::frictionInTheAirIsNoTouch() {
    constexpr double kTissue_N_per_m = 600.0, kOwn_N = 0.1,
                     kGrip_N_per_m = mechanisms::HandParameters{}.gripStiffness_N_per_m;
    FingerSenses senses(noiseless(), {}, {}, 1);
    FingerOrder order;
    order.press = 1;
    order.attendFrom_s = 1.2;
    order.attendUntil_s = 1.5;
    mechanisms::HandPerception seen;
    bool told = false, touchedInTheAir = false;
    for (int i = 0; i < 1600 && !told; ++i) {
        seen.time_s = 0.001 * i;
        const double tip_m = std::max(0.010 - 0.013 * i / 1000.0, -0.003); // down by 13 mm in a second
        const double tissue_N = kTissue_N_per_m * std::max(0.0, -tip_m);
        seen.f_T_D = {0.0, 0.0, tissue_N + kOwn_N};
        seen.p_DT = {0.0, 0.0, tip_m - seen.f_T_D.z() / kGrip_N_per_m};
        told = senses.feel(seen, order);
        touchedInTheAir |= senses.touching() && tip_m > 0.0;
    }
    QVERIFY(told && !touchedInTheAir);
    QVERIFY(std::abs(senses.press().force_N - kTissue_N_per_m * 0.003 - kOwn_N) < 1e-9);
    QVERIFY2(std::abs(senses.press().depth_m - 0.003) < 1e-5,
             qPrintable(QString::number(senses.press().depth_m)));
}

// SD of felt stiffness over its mean: force, depth and memory together, and nothing else.
void TestPalpationPerception::noiseIsWhatItSays() {
    PalpationPerceptionSettings settings;
    settings.hand.forceFloorSd_N = 0.0;
    FingerSenses senses(settings, {}, {}, 7);
    mechanisms::HandPerception seen;
    seen.fingertip = true;
    seen.pad.normalForce_N = 1.5;
    double sum = 0.0, squares = 0.0;
    const int n = 400;
    for (int i = 1; i <= n; ++i) {
        const double k = pressOnce(senses, seen, 0.005, i).stiffness_N_per_m;
        sum += k;
        squares += k * k;
    }
    const double mean = sum / n, sd = std::sqrt(squares / n - mean * mean) / mean;
    const double looks = 0.300 / settings.hand.forceNoiseTime_s;
    const double expected = std::sqrt(0.07 * 0.07 / looks + 0.08 * 0.08 + 0.12 * 0.12);
    QVERIFY2(std::abs(sd - expected) < 4.0 * expected / std::sqrt(2.0 * n),
             qPrintable(QString("%1, %2").arg(sd).arg(expected)));
}

void TestPalpationPerception::mapFindsWhereItIs() {
    EvidenceMap map({0.04, 0.04});
    const Suspicion lump{{0.012, -0.019}, 0.5, 0.0, 0.013};
    pressGrid(map, {lump}, 0.0, 0.0, 1);
    const Suspicion found = weighed(map);
    QVERIFY2((found.place_m - lump.place_m).norm() < 0.0005,
             qPrintable(QString("%1").arg((found.place_m - lump.place_m).norm())));
    QVERIFY(std::abs(found.amplitude - 0.5) < 0.05);
    QCOMPARE(found.width_m, 0.013);
}

// The strongest of a map without a lump exceeds the expert's criterion seldom: at most so often as 40 places
// of 1 in 2000 allow, within 3 standard errors of that many maps.
void TestPalpationPerception::mapOfNoiseStaysBelow() {
    const int n = 60;
    int over = 0;
    for (int i = 0; i < n; ++i) {
        EvidenceMap map({0.04, 0.04});
        pressGrid(map, {}, 0.16, 0.06, 100 + static_cast<std::uint64_t>(i));
        over += weighed(map).evidence > PalpationOperatorSettings{}.criterion ? 1 : 0;
    }
    const double most = 40.0 / 2000.0;
    QVERIFY2(over <= n * most + 3.0 * std::sqrt(n * most), qPrintable(QString::number(over)));
}

void TestPalpationPerception::mapTellsTwoApart() {
    EvidenceMap map({0.04, 0.04});
    const Suspicion strong{{-0.020, 0.0}, 0.6, 0.0, 0.013}, weak{{0.020, 0.010}, 0.4, 0.0, 0.013};
    pressGrid(map, {strong, weak}, 0.05, 0.02, 5);
    const Suspicion first = weighed(map);
    QVERIFY((first.place_m - strong.place_m).norm() < 0.003);
    map.explain(first);
    const Suspicion second = weighed(map);
    QVERIFY((second.place_m - weak.place_m).norm() < 0.003);
    map.explain(second);
    QVERIFY(weighed(map).evidence < 4.0);
}

// Lean points away from what is stiff: where stiffness tells nothing it still tells where.
void TestPalpationPerception::leanAlonePointsAtIt() {
    EvidenceMap map({0.04, 0.04});
    pressGrid(map, {{{0.010, 0.006}, 0.6, 0.0, 0.013}}, 0.05, 0.01, 9, true);
    QVERIFY((weighed(map).place_m - Vec2(0.010, 0.006)).norm() < 0.008);
}

// Least squares by hand. Twelve presses lie 8 mm from a place, half of them on either side. All lean away
// from it and equally far across; their stiffness differs, but in the same way on both sides.
void TestPalpationPerception::whatIsFeltIsWeighedByItsNoise() {
    constexpr double kAway_m = 0.008, kDepth_m = 0.006, kLean_rad = 0.10, kAcross_rad = 0.05, kUneven = 0.1;
    constexpr double kToSd = 1.4826; // of a normal distribution: SD over median absolute deviation
    EvidenceMap map({0.04, 0.04});
    for (const double side : {-1.0, 1.0})
        for (const double across : {-kAcross_rad, kAcross_rad})
            for (const double share : {1.0 - kUneven, 1.0, 1.0 + kUneven}) {
                Press press;
                press.place_m = Vec2(side * kAway_m, 0.0);
                press.depth_m = kDepth_m;
                press.stiffness_N_per_m = 300.0 * share;
                press.lean_rad = Vec2(side * kLean_rad, across);
                map.add(press);
            }
    map.begin();
    const Suspicion found = map.at(Vec2::Zero());
    const double w2 = found.width_m * found.width_m, q = 1.0 / (1.0 + kAway_m * kAway_m / w2);
    const double stiffness = q * q * q, lean = 3.0 * kDepth_m * kAway_m / w2 * stiffness * q;
    const double ofStiffness = 1.0 / std::pow(kToSd * kUneven, 2),
                 ofLean = 1.0 / std::pow(0.5 * kToSd * (kLean_rad + kAcross_rad), 2);
    const double most = 12.0 * (ofStiffness * stiffness * stiffness + ofLean * lean * lean);
    const double speaks = 12.0 * ofLean * lean * kLean_rad; // what is uneven cancels out
    QVERIFY2(std::abs(found.amplitude - speaks / most) < 1e-9, qPrintable(QString::number(found.amplitude)));
    QVERIFY2(std::abs(found.evidence - speaks / std::sqrt(most)) < 1e-9,
             qPrintable(QString::number(found.evidence)));
}

void TestPalpationPerception::gridCoversTheArea() {
    core::Random random(1);
    SearchPath path;
    PalpationOperatorSettings settings;
    path.plan(settings, {{-0.04, -0.03}, {0.04, 0.03}, 1, 0.0}, 200, random);
    QVERIFY(path.spots() >= 80 - 10 && path.spots() <= 100);
    // Nowhere is farther from a spot than half the diagonal of its spacing.
    std::vector<Vec2> spots;
    Vec2 spot, previous(0.0, 0.0);
    while (path.next(spot)) {
        if (!spots.empty())
            QVERIFY((spot - previous).norm() < 0.0095); // strip after strip, to and fro
        spots.push_back(previous = spot);
    }
    for (int i = 0; i < 500; ++i) {
        const Vec2 place(random.uniform(-0.04, 0.04), random.uniform(-0.03, 0.03));
        double nearest = 1.0;
        for (const Vec2& s : spots)
            nearest = std::min(nearest, (s - place).norm());
        QVERIFY(nearest < 0.009 / std::sqrt(2.0));
    }
    path.plan(settings, {{-0.04, -0.03}, {0.04, 0.03}, 1, 0.0}, 30, random);
    QVERIFY(path.spots() <= 30 && path.spots() >= 16);
}

// The second finger presses what the first leaves out.
void TestPalpationPerception::twoFingersShareTheColumns() {
    core::Random random(1);
    SearchPath path;
    const SearchShare share{{-0.036, -0.03}, {0.036, 0.03}, 2, 0.018};
    path.plan({}, share, 200, random);
    std::vector<double> columns;
    Vec2 spot;
    while (path.next(spot))
        for (const double x : {spot.x(), spot.x() + 0.018})
            if (std::none_of(columns.begin(), columns.end(),
                             [&](double c) { return std::abs(c - x) < 1e-6; }))
                columns.push_back(x);
    std::sort(columns.begin(), columns.end());
    QCOMPARE(columns.size(), std::size_t(8));
    for (std::size_t i = 1; i < columns.size(); ++i)
        QVERIFY(std::abs(columns[i] - columns[i - 1] - 0.009) < 1e-9);
}

void TestPalpationPerception::spiralAndRandomStayInside() {
    for (const char* name : {"intermediate", "novice"}) {
        core::Random random(3);
        SearchPath path;
        path.plan(*palpationOperatorSettings(name), {{-0.04, -0.02}, {0.04, 0.02}, 1, 0.0}, 60, random);
        QVERIFY(path.spots() >= 30 && path.spots() <= SearchPath::kMost);
        Vec2 spot;
        while (path.next(spot))
            QVERIFY(std::abs(spot.x()) <= 0.04 && std::abs(spot.y()) <= 0.02);
    }
}

void TestPalpationPerception::badSettingsAreRefused() {
    QCOMPARE(palpationOperatorSettings("nobody").error().code, core::ErrorCode::notFound);
    for (const std::string_view name : palpationOperatorNames())
        QVERIFY(makePalpationOperator(*palpationOperatorSettings(name), {}, 1));
    PalpationOperatorSettings settings;
    settings.hold_s = std::nan("");
    QVERIFY(!makePalpationOperator(settings, {}, 1));
    settings = {};
    settings.pressures = 4;
    QVERIFY(!makePalpationOperator(settings, {}, 1));
    PalpationBriefing briefing;
    briefing.hands = 3;
    QVERIFY(!makePalpationOperator({}, briefing, 1));
    briefing = {};
    briefing.bandLow_N = 3.0;
    const auto refused = makePalpationOperator({}, briefing, 1);
    QVERIFY(!refused && QString::fromStdString(refused.error().message).contains("bandHigh_N"));
}

QTEST_APPLESS_MAIN(TestPalpationPerception)
#include "test_palpation_perception.moc"
