// SPDX-License-Identifier: GPL-3.0-or-later
// The tube's law and its segments against closed forms; passivity of what is elastic over all hands.
#include "core/random.h"
#include "core/units.h"
#include "modules/exercises/elastic_tube/simulation/tube_chain.h"
#include "simulation/tube/tube_segment.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;

namespace {

constexpr double kLength_m = 0.045;
const Vec3 kStill = Vec3::Zero();

TubeShape shapeOf(std::size_t nodes, bool fixed, double stiffening_per_m = 0.0) {
    TubeShape shape;
    shape.law.elastic = {60.0, stiffening_per_m};
    shape.law.limit_m = 0.9 * kLength_m;
    shape.length_m = kLength_m;
    shape.nodes = nodes;
    shape.fixed = fixed;
    if (nodes == 3)
        shape.share = {0.0, 0.78, 1.0};
    return shape;
}

NodeHold at(const Vec3& p, const Vec3& v = Vec3::Zero()) {
    return {true, p, v};
}

/// A smooth closed path: three harmonics an axis round `centre`, within ± reach.
struct Loop {
    Vec3 centre;
    double amplitude[3][3];
    double phase[3][3];
    Loop(core::Random& random, const Vec3& c, double reach) : centre(c) {
        for (int axis = 0; axis < 3; ++axis)
            for (int h = 0; h < 3; ++h) {
                amplitude[axis][h] = random.uniform(-1.0, 1.0) * reach / 3.0;
                phase[axis][h] = random.uniform(0.0, 2.0 * core::kPi);
            }
    }
    Vec3 at(double turn) const {
        Vec3 p = centre;
        for (int axis = 0; axis < 3; ++axis)
            for (int h = 0; h < 3; ++h)
                p[axis] += amplitude[axis][h] * std::sin(2.0 * core::kPi * (h + 1) * turn + phase[axis][h]);
        return p;
    }
};

/// Work that two hands put in along their loops, trapezoid rule; backwards where asked.
double workOf(TubeChain chain, std::size_t a, std::size_t b, const Loop& first, const Loop& second,
              bool backwards) {
    constexpr int kSteps = 4000;
    double work_J = 0.0;
    Vec3 pa = Vec3::Zero(), pb = Vec3::Zero(), fa = Vec3::Zero(), fb = Vec3::Zero();
    for (int i = 0; i <= kSteps; ++i) {
        const double turn = static_cast<double>(backwards ? kSteps - i : i) / kSteps;
        TubeChain::Holds holds;
        holds[a] = at(first.at(turn));
        holds[b] = at(second.at(turn));
        const TubeAnswer answer = chain.step(holds);
        if (i > 0) {
            if (!(chain.shape().fixed && a == 0))
                work_J -= 0.5 * (fa + answer.force[a]).dot(holds[a].p_W - pa);
            work_J -= 0.5 * (fb + answer.force[b]).dot(holds[b].p_W - pb);
        }
        pa = holds[a].p_W;
        pb = holds[b].p_W;
        fa = answer.force[a];
        fb = answer.force[b];
    }
    return work_J;
}

} // namespace

class TestElasticTubeChain : public QObject {
    Q_OBJECT
private slots:
    void tensionAndEnergyAreClosedForms();
    void segmentsInSeriesAreTheTube();
    void forceIsTheGradient();
    void slackIsNothing();
    void wherePullBegins();
    void dampingNeverPushesAndNeverSteps();
    void forcesAreEqualAndOpposite();
    void closedLoopsOfBothHandsMakeNothing_data();
    void closedLoopsOfBothHandsMakeNothing();
    void aFreePlaceBetweenFeelsLikeTheWholeTube();
    void gripsOfASlackTubePullAtNobody();
    void lettingGoNeverSteps();
    void recoilMakesNoEnergy();
    void aSettledEndPullsAtNobody();
    void anUnfixedTubeIsDraggedWithoutForce();
    void afterTheLimitTensionStays();
};

void TestElasticTubeChain::tensionAndEnergyAreClosedForms() {
    for (const double b : {0.0, 40.0, 90.0}) {
        TubeLaw law{{80.0, b}, 0.0, 0.04};
        for (const double x : {1e-6, 0.001, 0.012, 0.031, 0.04}) { // to the limit: the checked range
            const double tension = b == 0.0 ? 80.0 * x : 80.0 / b * (std::exp(b * x) - 1.0);
            QVERIFY(std::abs(law.tension_N(x) - tension) < 1e-12 * (1.0 + tension) + 1e-14);
            double integral = 0.0; // Simpson
            constexpr int n = 2000;
            for (int i = 0; i < n; ++i) {
                const double l = x * i / n, r = x * (i + 1) / n;
                integral += (r - l) / 6.0 *
                            (law.tension_N(l) + 4.0 * law.tension_N(0.5 * (l + r)) + law.tension_N(r));
            }
            QVERIFY(std::abs(law.energy_J(x) - integral) < 1e-12);
            QVERIFY(std::abs(law.slope_N_per_m(x) - 80.0 * std::exp(b * x)) < 1e-9);
        }
        QCOMPARE(law.tension_N(0.0), 0.0);
        QCOMPARE(law.tension_N(-0.01), 0.0);
        QCOMPARE(law.energy_J(-0.01), 0.0);
    }
}

void TestElasticTubeChain::segmentsInSeriesAreTheTube() {
    const TubeLaw law{{60.0, 50.0}, 0.0, 0.04};
    const Vec3 base(0.01, 0.0, 0.0), end(0.02, 0.03, 0.06);
    const SegmentPull whole = pullOf(law, kLength_m, kLength_m, base, end, kStill);
    const double share = 0.78;
    const Vec3 middle = base + share * (end - base);
    const SegmentPull lower = pullOf(law, kLength_m, share * kLength_m, base, middle, kStill);
    const SegmentPull upper = pullOf(law, kLength_m, (1.0 - share) * kLength_m, middle, end, kStill);
    QVERIFY(whole.tension_N > 0.5);
    QVERIFY(std::abs(lower.tension_N - whole.tension_N) < 1e-12 &&
            std::abs(upper.tension_N - whole.tension_N) < 1e-12);
    QVERIFY(std::abs(lower.energy_J + upper.energy_J - whole.energy_J) < 1e-15);
    QVERIFY(std::abs(1.0 / lower.stiffness_N_per_m + 1.0 / upper.stiffness_N_per_m -
                     1.0 / whole.stiffness_N_per_m) < 1e-12);
    QVERIFY(std::abs(lower.stretch_m - whole.stretch_m) < 1e-15);
}

void TestElasticTubeChain::forceIsTheGradient() {
    const TubeLaw law{{60.0, 50.0}, 0.0, 0.04};
    const Vec3 base(0.0, 0.0, 0.0), end(0.02, -0.01, 0.055);
    const SegmentPull pull = pullOf(law, kLength_m, 0.8 * kLength_m, base, end, kStill);
    constexpr double h = 1e-6;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 plus = end, minus = end;
        plus[axis] += h;
        minus[axis] -= h;
        const double slope = (pullOf(law, kLength_m, 0.8 * kLength_m, base, plus, kStill).energy_J -
                              pullOf(law, kLength_m, 0.8 * kLength_m, base, minus, kStill).energy_J) /
                             (2.0 * h);
        QVERIFY(std::abs(pull.onFirst[axis] - slope) < 1e-6); // on the second: −slope
    }
}

void TestElasticTubeChain::slackIsNothing() {
    TubeShape shape = shapeOf(2, true);
    shape.law.viscosity_Ns_per_m = 2.0;
    TubeChain chain(shape);
    TubeChain::Holds holds;
    holds[1] = at({0.02, 0.01, 0.03}, {0.1, 0.0, 0.3});
    const TubeAnswer answer = chain.step(holds);
    QVERIFY(answer.force[1] == Vec3::Zero());
    QCOMPARE(answer.tension_N, 0.0);
    QCOMPARE(answer.stretch_m, 0.0);
    QCOMPARE(answer.energy_J, 0.0);
}

/// What is free in the middle holds nobody: a place is slack as far as the tube reaches from the next one
/// that is held.
void TestElasticTubeChain::wherePullBegins() {
    TubeChain chain(shapeOf(3, false));
    const Vec3 low(0.0, 0.0, 0.02), along(0.6, 0.0, 0.8);
    const auto holding = [&](std::initializer_list<std::size_t> nodes, const Vec3& p) {
        TubeChain::Holds holds;
        for (const std::size_t node : nodes)
            holds[node] = at(p);
        for (int tick = 0; tick < 3000; ++tick) // until what was let go has come back
            chain.step(holds);
    };
    const auto pullsFrom = [&](std::size_t node, double rest_m) {
        return chain.slackAt(node, low + 0.999 * rest_m * along) &&
               !chain.slackAt(node, low + 1.001 * rest_m * along);
    };
    holding({2}, low);
    QVERIFY(pullsFrom(0, kLength_m));
    QVERIFY(pullsFrom(1, 0.22 * kLength_m));
    holding({0}, low);
    QVERIFY(pullsFrom(2, kLength_m));
    QVERIFY(pullsFrom(1, 0.78 * kLength_m));
    holding({1}, low);
    QVERIFY(pullsFrom(0, 0.78 * kLength_m));
    QVERIFY(pullsFrom(2, 0.22 * kLength_m));
}

void TestElasticTubeChain::dampingNeverPushesAndNeverSteps() {
    const TubeLaw law{{60.0, 0.0}, 5.0, 0.04};
    const Vec3 base = Vec3::Zero();
    double before_N = 0.0;
    for (double x = -0.001; x < 0.002;
         x += 1e-6) { // pulled through taut at 0.2 m/s: 1 N of damping, faded in over 0.5 mm
        const SegmentPull pull =
            pullOf(law, kLength_m, kLength_m, base, {0.0, 0.0, kLength_m + x}, {0.0, 0.0, 0.2});
        QVERIFY(std::abs(pull.tension_N - before_N) < 0.0025);
        before_N = pull.tension_N;
    }
    QVERIFY(std::abs(before_N - (0.12 + 1.0)) < 0.002);
    const SegmentPull back =
        pullOf(law, kLength_m, kLength_m, base, {0.0, 0.0, kLength_m + 0.002}, {0.0, 0.0, -0.5});
    QCOMPARE(back.tension_N, 0.0); // 0.12 − 2.5 N would push
    QVERIFY(back.energy_J > 0.0);
}

void TestElasticTubeChain::forcesAreEqualAndOpposite() {
    core::Random random(7);
    TubeShape shape = shapeOf(2, false, 40.0);
    shape.law.viscosity_Ns_per_m = 0.3;
    TubeChain chain(shape);
    for (int i = 0; i < 2000; ++i) {
        const auto any = [&] {
            return Vec3(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(0.0, 0.08));
        };
        TubeChain::Holds holds;
        holds[0] = at(any(), any());
        holds[1] = at(any(), any());
        const TubeAnswer answer = chain.step(holds);
        QVERIFY(answer.force[0] == -answer.force[1]);
        const Vec3 along = holds[1].p_W - holds[0].p_W;
        QVERIFY(answer.force[0].cross(along).norm() < 1e-12); // along the segment: no torque on the pair
        QVERIFY(answer.force[0].dot(along) >= 0.0);           // and it pulls
    }
}

void TestElasticTubeChain::closedLoopsOfBothHandsMakeNothing_data() {
    QTest::addColumn<bool>("fixed");
    QTest::addColumn<double>("stiffening_per_m");
    QTest::newRow("two hands, linear") << false << 0.0;
    QTest::newRow("two hands, stiffening") << false << 70.0;
    QTest::newRow("fixed, two grips, linear") << true << 0.0;
    QTest::newRow("fixed, two grips, stiffening") << true << 70.0;
}

void TestElasticTubeChain::closedLoopsOfBothHandsMakeNothing() {
    QFETCH(bool, fixed);
    QFETCH(double, stiffening_per_m);
    core::Random random(11);
    double worst_J = 0.0;
    for (int i = 0; i < 30; ++i) {
        TubeChain chain(shapeOf(fixed ? 3 : 2, fixed, stiffening_per_m));
        const Loop first(random, fixed ? Vec3(0.0, 0.0, 0.036) : Vec3(-0.025, 0.0, 0.03), 0.012);
        const Loop second(random, fixed ? Vec3(0.0, 0.0, 0.050) : Vec3(0.025, 0.0, 0.03), 0.012);
        for (const bool backwards : {false, true})
            worst_J = std::max(
                worst_J, std::abs(workOf(chain, fixed ? 1 : 0, fixed ? 2 : 1, first, second, backwards)));
    }
    QVERIFY2(worst_J < 1e-6, qPrintable(QString::number(worst_J)));
}

void TestElasticTubeChain::aFreePlaceBetweenFeelsLikeTheWholeTube() {
    TubeChain two(shapeOf(2, true));
    TubeChain three(shapeOf(3, true));
    core::Random random(3);
    const Loop loop(random, {0.0, 0.0, 0.055}, 0.02);
    for (int i = 0; i < 500; ++i) {
        TubeChain::Holds holds, more;
        holds[1] = more[2] = at(loop.at(i / 500.0));
        const TubeAnswer a = two.step(holds);
        const TubeAnswer b = three.step(more);
        QVERIFY((a.force[1] - b.force[2]).norm() < 1e-12);
        QVERIFY(std::abs(a.energy_J - b.energy_J) < 1e-15);
    }
}

void TestElasticTubeChain::gripsOfASlackTubePullAtNobody() {
    core::Random random(5);
    for (int i = 0; i < 500; ++i) {
        TubeChain chain(shapeOf(3, true));
        TubeChain::Holds holds;
        const double reach = random.uniform(0.0, 0.0449);
        Vec3 u(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.05, 1));
        holds[2] = at(reach * u.normalized());
        chain.step(holds);
        holds[1] = at(chain.place(1)); // takes hold of it where it is drawn
        const TubeAnswer answer = chain.step(holds);
        QVERIFY2(answer.tension_N < 1e-12, qPrintable(QString::number(answer.tension_N)));
    }
}

void TestElasticTubeChain::lettingGoNeverSteps() {
    // Two hands at a taut tube with a bend between them; one after the other lets go.
    TubeChain chain(shapeOf(3, true));
    TubeChain::Holds holds;
    const Vec3 middle(0.015, 0.0, 0.045), end(0.0, 0.01, 0.075);
    holds[1] = at(middle);
    holds[2] = at(end);
    Vec3 felt = chain.step(holds).force[1];
    QVERIFY(felt.norm() > 0.3);
    holds[2] = NodeHold{};
    double largest_N = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 now = chain.step(holds).force[1];
        largest_N = std::max(largest_N, (now - felt).norm());
        felt = now;
    }
    QVERIFY2(largest_N < 0.1, qPrintable(QString::number(largest_N))); // of about 5 N in the short tail
    TubeChain other(shapeOf(3, true));
    holds[1] = at(middle);
    holds[2] = at(end);
    felt = other.step(holds).force[2];
    holds[1] = NodeHold{};
    largest_N = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 now = other.step(holds).force[2];
        largest_N = std::max(largest_N, (now - felt).norm());
        felt = now;
    }
    QVERIFY2(largest_N < 0.1, qPrintable(QString::number(largest_N)));
    const SegmentPull whole = pullOf(other.shape().law, kLength_m, kLength_m, Vec3::Zero(), end, kStill);
    QVERIFY((felt + whole.onFirst).norm() < 1e-9); // and then it is the whole tube
}

void TestElasticTubeChain::recoilMakesNoEnergy() {
    core::Random random(17);
    for (int trial = 0; trial < 40; ++trial) {
        TubeChain chain(shapeOf(3, true));
        const Loop first(random, {0.0, 0.0, 0.040}, 0.012);
        const Loop second(random, {0.0, 0.0, 0.062}, 0.015);
        const bool endGoes = trial % 2 == 0;
        double supplied_J = 0.0;
        Vec3 p = Vec3::Zero(), f = Vec3::Zero();
        for (int i = 0; i <= 3000; ++i) {
            TubeChain::Holds holds;
            const std::size_t stays = endGoes ? 1 : 2;
            holds[1] = at(first.at(i / 1500.0));
            holds[2] = at(second.at(i / 1500.0));
            if (i >= 400)
                holds[endGoes ? 2 : 1] = NodeHold{};
            const TubeAnswer answer = chain.step(holds);
            if (i == 400)
                supplied_J = answer.energy_J;
            if (i > 400)
                supplied_J -=
                    f.dot(holds[stays].p_W - p) + 0.5 * (answer.force[stays] - f).dot(holds[stays].p_W - p);
            p = holds[stays].p_W;
            f = answer.force[stays];
            if (i >= 400)
                QVERIFY2(answer.energy_J <= supplied_J + 2e-6,
                         qPrintable(QString::number(answer.energy_J - supplied_J)));
        }
    }
}

void TestElasticTubeChain::aSettledEndPullsAtNobody() {
    TubeChain chain(shapeOf(3, true));
    TubeChain::Holds holds;
    holds[1] = at({0.0, 0.0, 0.034}); // slack
    for (int i = 0; i < 500; ++i)
        chain.step(holds);
    for (int i = 0; i < 200; ++i) { // drawn away at 0.2 m/s: what hangs on follows
        holds[1] = at({0.0, -0.00002 * i, 0.034 - 0.0001 * i});
        QCOMPARE(chain.step(holds).tension_N, 0.0);
    }
}

void TestElasticTubeChain::anUnfixedTubeIsDraggedWithoutForce() {
    TubeChain chain(shapeOf(2, false));
    TubeChain::Holds holds;
    Vec3 p = chain.place(1);
    for (int i = 0; i < 3000; ++i) {
        p += Vec3(0.00002, 0.00001, i < 1500 ? 0.00004 : -0.00002);
        holds[1] = at(p);
        QCOMPARE(chain.step(holds).tension_N, 0.0);
        QVERIFY((chain.place(1) - chain.place(0)).norm() <= kLength_m + 1e-12);
    }
    holds[1] = NodeHold{};
    for (int i = 0; i < 3000; ++i)
        chain.step(holds);
    QVERIFY(std::abs(chain.place(0).z() - chain.shape().radius_m) < 1e-6); // both on the floor again
    QVERIFY(std::abs(chain.place(1).z() - chain.shape().radius_m) < 1e-6);
}

void TestElasticTubeChain::afterTheLimitTensionStays() {
    const TubeLaw law{{60.0, 90.0}, 0.0, 0.04};
    QCOMPARE(law.tension_N(10.0), law.tension_N(0.04));
    QVERIFY(std::abs(law.energy_J(0.05) - law.energy_J(0.04) - 0.01 * law.tension_N(0.04)) < 1e-12);
    QCOMPARE(law.slope_N_per_m(0.05), 0.0);
}

QTEST_APPLESS_MAIN(TestElasticTubeChain)
#include "test_elastic_tube_chain.moc"
