// SPDX-License-Identifier: GPL-3.0-or-later
// The slow model's network against closed forms, for any input, and what a step costs in arithmetic.
#include "core/random.h"
#include "core/units.h"
#include "simulation/deformable/spring_network.h"
#include "simulation/geometry/mesh/make_mesh.h"

#include <QtTest>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;

namespace {

struct Dome {
    MeshShape shape;
    std::vector<bool> anchored;
    std::uint32_t apex = 0;
    std::uint32_t apexTriangle = 0;
};

Dome dome(double edge_m = 0.0015) {
    MeshSource source;
    source.shape = MeshSource::Shape::dome;
    source.plateRadius_m = 0.030;
    source.edge_m = edge_m;
    Dome made;
    made.shape = *makeMeshShape(source);
    for (std::uint32_t i = 0; i < made.shape.vertices.size(); ++i) {
        made.anchored.push_back(made.shape.vertices[i].z() < 1e-4);
        if (made.shape.vertices[i].z() > made.shape.vertices[made.apex].z())
            made.apex = i;
    }
    while (made.shape.triangles[made.apexTriangle][0] != made.apex)
        ++made.apexTriangle;
    return made;
}

std::unique_ptr<SpringNetwork> network(const Dome& of, const SpringNetworkParameters& parameters = {}) {
    auto made =
        SpringNetwork::create({of.shape.vertices, of.shape.triangles}, of.anchored, of.apex, parameters);
    return made ? std::move(*made) : nullptr;
}

/// A press straight down on the apex, `x` below the rest shape.
NetworkPush press(const Dome& of, double x, double k) {
    NetworkPush push;
    push.triangle = of.apexTriangle;
    push.weights = {1.0, 0.0, 0.0};
    push.normal = Vec3::UnitZ();
    push.p_Tool = of.shape.vertices[of.apex] - Vec3(0, 0, x);
    push.stiffness_N_per_m = k;
    return push;
}

} // namespace

class TestSpringNetwork : public QObject {
    Q_OBJECT
private slots:
    void aLastingPressFeelsBothSpringsInSeries_data();
    void aLastingPressFeelsBothSpringsInSeries();
    void everyFreeVertexGivesWay();
    void theVolumeThatIsKeptBulgesOut();
    void energyOnlyFallsWhenNobodyPresses();
    void recoversWithItsTimeConstant();
    void staysFiniteForAnyInput();
    void twoPressesAreTheSameInEitherOrder();
    void asManyAsThereMayBeAreTheSameInAnyOrder();
    void givesTheSameBitsAgain();
    void refusesWhatIsNoNetwork();
    void everyParameterHasItsRange();
    void aStepIsFarBelowTenMilliseconds();
};

void TestSpringNetwork::aLastingPressFeelsBothSpringsInSeries_data() {
    QTest::addColumn<double>("local");
    QTest::addColumn<double>("organ");
    QTest::newRow("local softer") << 300.0 << 900.0;
    QTest::newRow("equal") << 600.0 << 600.0;
    QTest::newRow("local far stiffer: an explicit coupling would diverge") << 2000.0 << 200.0;
}

void TestSpringNetwork::aLastingPressFeelsBothSpringsInSeries() {
    QFETCH(double, local);
    QFETCH(double, organ);
    const Dome of = dome();
    for (const double keeping : {0.0, 0.7, 0.95}) {
        SpringNetworkParameters parameters;
        parameters.stiffness_N_per_m = organ;
        parameters.volumeKeeping = keeping;
        const auto net = network(of, parameters);
        QVERIFY(net);
        const NetworkPush push = press(of, 0.003, local);
        double force = 0.0;
        for (int step = 0; step < 300; ++step)
            force = net->step(std::span(&push, 1))[0];
        const double series = 0.003 * local * organ / (local + organ);
        QVERIFY2(std::abs(force - series) < 1e-6 * series,
                 qPrintable(QString("%1 N, series %2 N").arg(force).arg(series)));
        const double givesWay = -net->displacement(of.apex).z();
        QVERIFY(std::abs(givesWay - series / organ) < 1e-6 * series / organ);
    }
}

/// A press on one vertex moves it inwards, whichever it is; an anchored one stays where it is.
void TestSpringNetwork::everyFreeVertexGivesWay() {
    const Dome of = dome(0.003);
    const auto net = network(of);
    QVERIFY(net);
    std::vector<bool> pressed(of.shape.vertices.size(), false);
    for (std::uint32_t t = 0; t < of.shape.triangles.size(); ++t)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = of.shape.triangles[t][corner];
            if (pressed[vertex])
                continue;
            pressed[vertex] = true;
            NetworkPush push;
            push.triangle = t;
            push.weights = {0.0, 0.0, 0.0};
            push.weights[corner] = 1.0;
            push.p_Tool = of.shape.vertices[vertex] - 0.002 * push.normal;
            net->reset();
            const double pushed_N = net->step(std::span(&push, 1))[0];
            const double inwards_m = -push.normal.dot(net->displacement(vertex));
            if (of.anchored[vertex])
                QCOMPARE(inwards_m, 0.0);
            else
                QVERIFY2(
                    pushed_N > 0.0 && inwards_m > 0.0 && inwards_m < 0.002,
                    qPrintable(QString("vertex %1: %2 N, %3 m").arg(vertex).arg(pushed_N).arg(inwards_m)));
        }
}

void TestSpringNetwork::theVolumeThatIsKeptBulgesOut() {
    const Dome of = dome();
    const auto pressedIn = [&](double keeping) {
        SpringNetworkParameters parameters;
        parameters.volumeKeeping = keeping;
        const auto net = network(of, parameters);
        const NetworkPush push = press(of, 0.005, 600.0);
        for (int step = 0; step < 300; ++step)
            (void)net->step(std::span(&push, 1));
        return net->volumePressedIn_m3();
    };
    const double free = pressedIn(0.0);
    QVERIFY(free > 1e-8); // 10 mm³ at least
    for (const double keeping : {0.5, 0.9}) {
        const double kept = pressedIn(keeping);
        // κ is a little lower with the volume spring, which carries its part: 1 - q, within a tenth of that
        QVERIFY2(std::abs(kept / free - (1.0 - keeping)) < 0.1 * (1.0 - keeping),
                 qPrintable(QString("%1 of it at q = %2").arg(kept / free).arg(keeping)));
    }
}

void TestSpringNetwork::energyOnlyFallsWhenNobodyPresses() {
    const Dome of = dome(0.003);
    SpringNetworkParameters parameters;
    parameters.recoveryTime_s = 0.0; // masses and springs alone
    parameters.mass_kg = 0.5;        // enough to swing
    const auto net = network(of, parameters);
    const NetworkPush push = press(of, 0.006, 800.0);
    for (int step = 0; step < 20; ++step)
        (void)net->step(std::span(&push, 1));
    double before = net->elasticEnergy_J() + net->kineticEnergy_J();
    QVERIFY(before > 1e-3);
    for (int step = 0; step < 200; ++step) {
        (void)net->step({});
        const double now = net->elasticEnergy_J() + net->kineticEnergy_J();
        QVERIFY(now <= before * (1.0 + 1e-12));
        before = now;
    }
    QVERIFY(before < 1e-9);
}

void TestSpringNetwork::recoversWithItsTimeConstant() {
    // Without mass and volume spring: (1 + τ/h) δ = -u, so u falls by τ/(τ + h) a step.
    const Dome of = dome(0.003);
    SpringNetworkParameters parameters;
    parameters.recoveryTime_s = 0.2;
    parameters.volumeKeeping = 0.0;
    parameters.mass_kg = 0.001;
    const auto net = network(of, parameters);
    const NetworkPush push = press(of, 0.004, 800.0);
    for (int step = 0; step < 200; ++step)
        (void)net->step(std::span(&push, 1));
    (void)net->step({});
    const double from = net->displacement(of.apex).z();
    for (int step = 0; step < 10; ++step)
        (void)net->step({});
    const double expected = std::pow(0.2 / 0.233, 10);
    QVERIFY(std::abs(net->displacement(of.apex).z() / from - expected) < 0.03 * expected);
}

void TestSpringNetwork::staysFiniteForAnyInput() {
    const Dome of = dome(0.003);
    core::Random random(11);
    SpringNetworkParameters parameters;
    const auto net = network(of, parameters);
    const double most = parameters.stiffness_N_per_m * parameters.deepest_m;
    for (int step = 0; step < 2000; ++step) {
        std::array<NetworkPush, 4> pushes;
        for (NetworkPush& push : pushes) {
            push.triangle = static_cast<std::uint32_t>(random.below(of.shape.triangles.size() + 2));
            const double a = random.uniform(), b = random.uniform(0.0, 1.0 - a);
            push.weights = {a, b, 1.0 - a - b};
            push.normal = Vec3(random.normal(), random.normal(), random.normal()).normalized();
            push.p_Tool = random.uniform(0.0, 0.2) * Vec3(random.normal(), random.normal(), random.normal());
            push.stiffness_N_per_m = std::pow(10.0, random.uniform(-2.0, 6.0));
            if (random.below(20) == 0)
                push.p_Tool.x() = std::numeric_limits<double>::quiet_NaN();
            if (random.below(20) == 0)
                push.stiffness_N_per_m = std::numeric_limits<double>::infinity();
        }
        for (const double pushed : net->step(pushes))
            QVERIFY(pushed >= 0.0 && pushed <= most);
        for (std::uint32_t i = 0; i < of.shape.vertices.size(); i += 7)
            QVERIFY(net->displacement(i).norm() < 0.1); // four presses of 7 N at most, anywhere
    }
    for (int step = 0; step < 200; ++step)
        (void)net->step({});
    QVERIFY(net->elasticEnergy_J() < 1e-9); // and it comes back
}

void TestSpringNetwork::twoPressesAreTheSameInEitherOrder() {
    const Dome of = dome(0.003);
    NetworkPush one = press(of, 0.003, 500.0);
    NetworkPush two = one;
    for (std::uint32_t t = 0; t < of.shape.triangles.size(); ++t) {
        const Vec3& at = of.shape.vertices[of.shape.triangles[t][0]];
        if ((at - Vec3(0.008, 0.0, 0.018)).norm() < 0.004)
            two.triangle = t;
    }
    const Vec3 at = of.shape.vertices[of.shape.triangles[two.triangle][0]];
    two.normal = at.normalized();
    two.p_Tool = at - 0.002 * two.normal;
    const auto a = network(of);
    const auto b = network(of);
    std::array<double, 4> first{}, second{};
    for (int step = 0; step < 100; ++step) {
        first = a->step(std::array{one, two});
        second = b->step(std::array{two, one});
    }
    QVERIFY(first[0] > 0.1 && first[1] > 0.1);
    QVERIFY(std::abs(first[0] - second[1]) < 1e-9 && std::abs(first[1] - second[0]) < 1e-9);
    // the neighbour's press takes some of the surface away from the first one
    const auto alone = network(of);
    double force = 0.0;
    for (int step = 0; step < 100; ++step)
        force = alone->step(std::array{one})[0];
    QVERIFY(first[0] < force - 1e-3);
}

void TestSpringNetwork::asManyAsThereMayBeAreTheSameInAnyOrder() {
    const Dome of = dome(0.003);
    std::array<NetworkPush, core::kMaxTools> pushes;
    for (std::size_t i = 0; i < pushes.size(); ++i) { // around the apex, each deeper than the one before
        const double angle = 0.5 * core::kPi * static_cast<double>(i);
        const Vec3 way = Vec3(0.5 * std::cos(angle), 0.5 * std::sin(angle), 1.0).normalized();
        NetworkPush& push = pushes[i];
        push = press(of, 0.0, 500.0);
        double nearest = -1.0;
        for (std::uint32_t t = 0; t < of.shape.triangles.size(); ++t) {
            const double along = of.shape.vertices[of.shape.triangles[t][0]].normalized().dot(way);
            if (along > nearest) {
                nearest = along;
                push.triangle = t;
            }
        }
        const Vec3 at = of.shape.vertices[of.shape.triangles[push.triangle][0]];
        push.normal = at.normalized();
        push.p_Tool = at - (0.001 + 0.0005 * static_cast<double>(i)) * push.normal;
    }
    auto turned = pushes;
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    const auto a = network(of);
    const auto b = network(of);
    std::array<double, core::kMaxTools> first{}, second{};
    for (int step = 0; step < 100; ++step) {
        first = a->step(pushes);
        second = b->step(turned);
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
        QVERIFY2(first[i] > 0.05, qPrintable(QString::number(first[i])));
        QVERIFY(std::abs(first[(i + 1) % first.size()] - second[i]) < 1e-9);
    }
}

void TestSpringNetwork::givesTheSameBitsAgain() {
    const Dome of = dome(0.003);
    const auto a = network(of);
    const auto b = network(of);
    for (int step = 0; step < 50; ++step) {
        const NetworkPush push = press(of, 0.001 * (step % 7), 700.0);
        QCOMPARE(a->step(std::span(&push, 1)), b->step(std::span(&push, 1)));
    }
    a->reset();
    const auto c = network(of);
    const NetworkPush push = press(of, 0.002, 700.0);
    QCOMPARE(a->step(std::span(&push, 1)), c->step(std::span(&push, 1)));
    for (std::uint32_t i = 0; i < of.shape.vertices.size(); ++i)
        QCOMPARE(a->displacement(i), c->displacement(i));
}

void TestSpringNetwork::refusesWhatIsNoNetwork() {
    const Dome of = dome(0.003);
    const SurfaceView surface{of.shape.vertices, of.shape.triangles};
    const auto refused = [](const auto& result, const char* what) {
        return !result && QString::fromStdString(result.error().message).contains(what);
    };
    QVERIFY(refused(SpringNetwork::create(surface, of.anchored, 0xffffffu, {}), "reference vertex"));
    QVERIFY(refused(SpringNetwork::create(surface, {true}, of.apex, {}), "anchors"));
    QVERIFY(refused(SpringNetwork::create(surface, std::vector<bool>(of.anchored.size(), true), of.apex, {}),
                    "anchored"));
    SpringNetworkParameters soft;
    soft.stiffness_N_per_m = 1.0;
    QVERIFY(refused(SpringNetwork::create(surface, of.anchored, of.apex, soft), "stiffness_N_per_m is 1"));
    SpringNetworkParameters nan;
    nan.spread_m = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(refused(SpringNetwork::create(surface, of.anchored, of.apex, nan), "spread_m"));
    auto vertices = of.shape.vertices;
    vertices[3].x() = std::numeric_limits<double>::infinity();
    QVERIFY(
        refused(SpringNetwork::create({vertices, of.shape.triangles}, of.anchored, of.apex, {}), "vertex 3"));
    auto triangles = of.shape.triangles;
    triangles[5][1] = 1'000'000;
    QVERIFY(refused(SpringNetwork::create({of.shape.vertices, triangles}, of.anchored, of.apex, {}),
                    "triangle 5"));
    const std::vector<MeshTriangle> none;
    QVERIFY(!SpringNetwork::create({of.shape.vertices, none}, of.anchored, of.apex, {}));
}

/// The ranges that spring_network.h states: their ends are taken, what is beyond is named with them.
void TestSpringNetwork::everyParameterHasItsRange() {
    const Dome of = dome(0.003);
    struct Range {
        const char* name;
        double SpringNetworkParameters::*value;
        double low, high;
    };
    using P = SpringNetworkParameters;
    for (const Range& range :
         {Range{"stiffness_N_per_m", &P::stiffness_N_per_m, 20.0, 5000.0},
          Range{"spread_m", &P::spread_m, 0.001, 0.030}, Range{"mass_kg", &P::mass_kg, 0.001, 1.0},
          Range{"recoveryTime_s", &P::recoveryTime_s, 0.0, 2.0},
          Range{"volumeKeeping", &P::volumeKeeping, 0.0, 0.95},
          Range{"deepest_m", &P::deepest_m, 0.001, 0.030}, Range{"step_s", &P::step_s, 0.010, 0.050}}) {
        const auto made = [&](double value) {
            P p;
            p.*range.value = value;
            const auto net =
                SpringNetwork::create({of.shape.vertices, of.shape.triangles}, of.anchored, of.apex, p);
            return net ? QString() : QString::fromStdString(net.error().message);
        };
        QCOMPARE(made(range.low), QString());
        QCOMPARE(made(range.high), QString());
        for (const double beyond : {range.low - 1e-4, 1.0001 * range.high})
            QCOMPARE(made(beyond), QStringLiteral("deformable organ: %1 is %2, expected %3 to %4")
                                       .arg(QLatin1String(range.name))
                                       .arg(beyond, 0, 'f', 6)
                                       .arg(range.low, 0, 'f', 6)
                                       .arg(range.high, 0, 'f', 6));
    }
}

void TestSpringNetwork::aStepIsFarBelowTenMilliseconds() {
    // Told, not asserted in time: what is asserted is the arithmetic, seven substitutions of the factor.
    const Dome of = dome(0.0013);
    const auto net = network(of);
    QVERIFY(net->freeVertices() > 1300 && net->freeVertices() < 1800);
    QVERIFY2(net->factorEntries() < 40 * net->freeVertices(),
             qPrintable(QString::number(net->factorEntries())));
    const std::array pushes{press(of, 0.003, 500.0), press(of, 0.002, 500.0)};
    const auto begin = std::chrono::steady_clock::now();
    for (int step = 0; step < 100; ++step)
        (void)net->step(pushes);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    qInfo("%zu free vertices, %zu entries of L, %.3f ms a step", net->freeVertices(), net->factorEntries(),
          took.count() / 100);
}

QTEST_APPLESS_MAIN(TestSpringNetwork)
#include "test_spring_network.moc"
