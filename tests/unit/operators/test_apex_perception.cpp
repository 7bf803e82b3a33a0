// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/operators/apex_fit.h"
#include "modules/exercises/sphere_apex/operators/reach.h"
#include "modules/exercises/sphere_apex/operators/scan_path.h"
#include "operators/hand/senses.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <vector>

using namespace chiron;
using namespace chiron::operators;
using core::Vec2;
using core::Vec3;

class TestApexPerception : public QObject {
    Q_OBJECT
private slots:
    void placeIsFeltWithItsNoise();
    void forceIsFeltWithItsNoise();
    void sightReplacesProprioception();
    void hiddenObjectsStayHidden();
    void sameSeedSamePercepts();
    void fitFindsTheApexOfABall();
    void fitSeesNoHillOnAPlane();
    void scanCoversTheDisc();
    void reachIsSmoothAndBounded();
};

namespace {

/// Felt place minus true place, or the felt force, one a look over `ticks` of a constant world.
std::vector<Percept> feel(Senses& senses, const mechanisms::HandPerception& world, int ticks) {
    std::vector<Percept> looks;
    for (int i = 0; i < ticks; ++i)
        if (senses.feel(world))
            looks.push_back(senses.percept());
    return looks;
}

} // namespace

// SD of felt place: √(bias² + quick²), over trainees and time; a difference over 1 s is mostly quick noise.
void TestApexPerception::placeIsFeltWithItsNoise() {
    const PerceptionSettings settings;
    double squares = 0.0, second = 0.0;
    int count = 0, pairs = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Senses senses(settings, seed);
        const auto looks = feel(senses, {}, 20000);
        for (std::size_t i = 0; i < looks.size(); ++i) {
            squares += looks[i].place.x() * looks[i].place.x();
            ++count;
            if (i >= 100) {
                const double d = looks[i].place.x() - looks[i - 100].place.x();
                second += d * d;
                ++pairs;
            }
        }
    }
    const double sd = std::sqrt(squares / count);
    const double expected = std::hypot(settings.positionBiasSd_m, settings.positionNoiseSd_m);
    QVERIFY2(std::abs(sd - expected) < 0.15 * expected,
             qPrintable(QString::number(sd))); // 200 trainees: ±5 % (1 SD)
    const double bias2 =
        2.0 * std::pow(settings.positionBiasSd_m, 2) * (1.0 - std::exp(-1.0 / settings.positionBiasTime_s));
    const double quick2 =
        2.0 * std::pow(settings.positionNoiseSd_m, 2) * (1.0 - std::exp(-1.0 / settings.positionNoiseTime_s));
    QVERIFY(std::abs(std::sqrt(second / pairs) - std::sqrt(bias2 + quick2)) <
            0.05 * std::sqrt(bias2 + quick2));
}

void TestApexPerception::forceIsFeltWithItsNoise() {
    const PerceptionSettings settings;
    mechanisms::HandPerception world;
    world.f_T_D = Vec3(0.0, 0.0, 2.0);
    double mean = 0.0, squares = 0.0, angle2 = 0.0;
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        Senses senses(settings, seed);
        for (const Percept& look : feel(senses, world, 5000)) {
            const double size = look.force.norm();
            mean += size;
            squares += size * size;
            const double tilt = std::atan2(look.force.x(), look.force.z());
            angle2 += tilt * tilt;
            ++count;
        }
    }
    mean /= count;
    const double sd = std::sqrt(squares / count - mean * mean);
    QVERIFY2(std::abs(sd / mean - 0.07) < 0.007,
             qPrintable(QString::number(sd / mean))); // Pang, Tan & Durlach 1991
    // 18° a look (25.6°/√2) with the slow misjudgement; the second tilt and the floor widen it by a few per
    // cent.
    const double expected = std::hypot(settings.directionNoiseSd_rad, settings.directionBiasSd_rad);
    QVERIFY2(std::abs(std::sqrt(angle2 / count) - expected) < 0.1 * expected,
             qPrintable(QString::number(std::sqrt(angle2 / count))));
    QVERIFY(std::abs(mean - 2.0) < 0.02);
}

void TestApexPerception::sightReplacesProprioception() {
    mechanisms::HandPerception world;
    world.cues.objectShown = true;
    world.p_DObject = Vec3(0.01, -0.02, 0.0);
    double squares = 0.0;
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Senses senses({}, seed);
        for (const Percept& look : feel(senses, world, 10000)) {
            QVERIFY(look.objectSeen && look.seenApex == Vec2(0.01, -0.02));
            squares += look.place.x() * look.place.x();
            ++count;
        }
    }
    const double sd = std::sqrt(squares / count);
    QVERIFY2(std::abs(sd - 0.0015) < 0.0001, qPrintable(QString::number(sd)));
}

void TestApexPerception::hiddenObjectsStayHidden() {
    mechanisms::HandPerception world;
    world.p_DObject = Vec3(0.01, -0.02, 0.0); // nobody should fill it, but if so
    Senses senses({}, 1);
    for (const Percept& look : feel(senses, world, 100))
        QVERIFY(!look.objectSeen && look.seenApex.isZero());
}

void TestApexPerception::sameSeedSamePercepts() {
    mechanisms::HandPerception world;
    world.f_T_D = Vec3(0.1, -0.3, 1.0);
    Senses a({}, 5), b({}, 5), c({}, 6);
    const auto one = feel(a, world, 5000), two = feel(b, world, 5000), three = feel(c, world, 5000);
    for (std::size_t i = 0; i < one.size(); ++i) {
        QVERIFY(one[i].place == two[i].place && one[i].force == two[i].force);
        QVERIFY(one[i].place != three[i].place);
    }
}

void TestApexPerception::fitFindsTheApexOfABall() {
    const Vec2 apex(0.004, -0.003);
    ApexFit fit(8.0, 0.01);
    Vec2 found(1.0, 1.0);
    QVERIFY(!fit.apex(found) && found == Vec2(1.0, 1.0)); // nothing felt yet
    for (int i = 0; i < 400; ++i) {
        const Vec2 place = apex + Vec2(0.01 * std::sin(0.05 * i) + 0.003, 0.002);
        fit.add(place, (place - apex) / 0.020);
    }
    QVERIFY(fit.apex(found));
    QVERIFY((found - apex).norm() < 1e-9);
    QVERIFY(std::abs(fit.steepening_per_m() - 50.0) < 1e-6); // 1/R
}

void TestApexPerception::fitSeesNoHillOnAPlane() {
    core::Random random(3);
    ApexFit fit(8.0, 0.01);
    Vec2 found;
    for (int i = 0; i < 2000; ++i)
        fit.add(Vec2(0.01 * std::sin(0.05 * i), 0.0), 0.05 * Vec2(random.normal(), random.normal()));
    QVERIFY(!fit.apex(found));
}

// Every ball of 18 mm radius (20 mm, felt 9 mm up) with its centre within 40 mm is met by a line.
void TestApexPerception::scanCoversTheDisc() {
    ScanPath path(0.055, 0.020);
    std::vector<std::pair<Vec2, Vec2>> lines;
    Vec2 from = path.end();
    do {
        if (path.onLine())
            lines.emplace_back(from, path.end());
        from = path.end();
    } while (path.next());
    QCOMPARE(lines.size(), std::size_t(5));
    for (double angle = 0.0; angle < 6.28; angle += 0.1) {
        const Vec2 centre = 0.040 * Vec2(std::cos(angle), std::sin(angle));
        double nearest = 1.0;
        for (const auto& [a, b] : lines) {
            const Vec2 along = b - a;
            const double t = std::clamp((centre - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (a + t * along - centre).norm());
        }
        QVERIFY2(nearest < 0.0125, qPrintable(QString::number(nearest)));
    }
}

void TestApexPerception::reachIsSmoothAndBounded() {
    Reach reach;
    reach.start(Vec3(0.0, 0.0, 0.05));
    Vec3 last(0.0, 0.0, 0.05), velocity = Vec3::Zero();
    for (int i = 0; i < 4000; ++i) {
        reach.wish(i < 2000 ? Vec3(0.3, 0.0, -0.2) : Vec3(-0.3, 0.1, 0.4));
        const auto wanted = reach.advance(0);
        QVERIFY((wanted.v_DDesired - velocity).norm() < 1.5e-3 * (1.0 + 1e-9) ||
                wanted.v_DDesired.cwiseAbs().minCoeff() == 0.0);
        QVERIFY((wanted.p_DDesired - last).norm() < 1e-3);
        QVERIFY(std::abs(wanted.p_DDesired.x()) <= 0.080 && wanted.p_DDesired.z() <= 0.080 + 1e-12);
        last = wanted.p_DDesired;
        velocity = wanted.v_DDesired;
    }
}

QTEST_APPLESS_MAIN(TestApexPerception)
#include "test_apex_perception.moc"
