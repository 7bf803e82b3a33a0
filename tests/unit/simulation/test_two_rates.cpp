// SPDX-License-Identifier: GPL-3.0-or-later
// Two rates: when requests go and answers take effect, that nothing steps at the update, and what is felt in
// the end.
#include "core/units.h"
#include "support/two_rate_bench.h"

#include <QtTest>
#include <algorithm>
#include <cstdio>
#include <deque>
#include <numeric>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;
using tests::softDome;

namespace {

/// Answers twice the number it was asked for.
class Doubler final : public ISlowModel {
public:
    explicit Doubler(SlowLink<int, int>& link) : m_link(link) {}
    bool step() noexcept override {
        return m_link.serve([](std::uint64_t, int asked) { return 2 * asked; });
    }

private:
    SlowLink<int, int>& m_link;
};

double at(const AnswerBlend& blend, std::uint64_t tick, const std::array<double, 16>& answers) {
    const BlendWeights w = blend.weights(tick);
    const auto value = [&](std::size_t i) { return answers[blend.numbers()[i] % 16]; };
    return w.newest * value(0) + w.previous * value(1) + w.before * value(2);
}

constexpr double kDepth_m = 0.003;
constexpr double kAcross_m = 0.004;

/// Presses 3 mm deep to and fro, while it slides; smooth.
Vec3 path(double t) {
    const double press = 0.5 * kDepth_m * (1.0 - std::cos(2.0 * core::kPi * 1.5 * t));
    return {kAcross_m * std::sin(2.0 * core::kPi * 0.4 * t), 0.002 * std::sin(2.0 * core::kPi * 0.7 * t),
            0.0201 - press};
}

struct Slide {
    double largestStep_N = 0.0; ///< ‖f(n) - f(n-1)‖
    double largestForce_N = 0.0;
    double fastest_m = 0.0; ///< tool, m a tick
    int applied = 0;
    std::uint64_t longestGap = 0;
};

Slide slide(bool blends, std::uint64_t seed) {
    const SphereApexParameters p = softDome();
    auto dome = std::move(*TouchedDome::make(p, planSphereApexTrials(p, 1)));
    if (!blends)
        dome->organ()->switchBlendingOffForTests();
    tests::LateModel late(*dome->organ(), seed);
    dome->begin(0, 0);
    Slide result;
    Vec3 before = Vec3::Zero();
    std::uint64_t last = 0;
    for (std::uint64_t n = 0; n < 12'000; ++n) {
        const double t = 1e-3 * static_cast<double>(n);
        const Vec3 v = (path(t + 5e-4) - path(t - 5e-4)) / 1e-3;
        if (dome->update(n, SlowUpdate::whenReady)) {
            ++result.applied;
            result.longestGap = std::max(result.longestGap, n - last);
            last = n;
        }
        const Vec3 f = dome->respond(0, path(t), v).force;
        dome->ask(n);
        late.tick();
        if (n > 0)
            result.largestStep_N = std::max(result.largestStep_N, (f - before).norm());
        result.largestForce_N = std::max(result.largestForce_N, f.norm());
        result.fastest_m = std::max(result.fastest_m, v.norm() * core::kTickSeconds);
        before = f;
    }
    return result;
}

} // namespace

class TestTwoRates : public QObject {
    Q_OBJECT
private slots:
    void asDueAppliesExactlyAtNPlusL();
    void whenReadyWaitsForTheAnswerAndForL();
    void aReplayAppliesWhereItWasRecorded();
    void oneRequestAtATime();
    void theBlendIsContinuousAtEveryApplication();
    void weightsSumToOneAndThePredictionIsLimited();
    void noStepIsFelt();
    void aQuickPressIsLocalALastingOneTheSeries();
    void anotherTrialBeginsAtRest();
    void theLargestDisplacementBoundsWhatIsShown();
    void thePredictionIsComparedWithWhatCame();
    void settingsAreTakenUpToTheirBounds();
};

void TestTwoRates::asDueAppliesExactlyAtNPlusL() {
    SlowLink<int, int> link({40, 33});
    Doubler model(link);
    std::vector<std::uint64_t> applied;
    for (std::uint64_t n = 0; n < 300; ++n) {
        if (link.take(n, SlowUpdate::asDue, model)) {
            applied.push_back(n);
            QCOMPARE(link.answer(), 2 * static_cast<int>(link.postedAt_ticks()));
        }
        if (link.mayPost(n))
            link.post(n, static_cast<int>(n));
    }
    QCOMPARE(applied, (std::vector<std::uint64_t>{33, 73, 113, 153, 193, 233, 273}));
}

void TestTwoRates::whenReadyWaitsForTheAnswerAndForL() {
    SlowLink<int, int> link({33, 33});
    Doubler model(link);
    link.post(0, 5);
    QVERIFY(model.step());
    QVERIFY(!model.step()); // answered once
    for (std::uint64_t n = 1; n < 33; ++n)
        QVERIFY(!link.take(n, SlowUpdate::whenReady, model)); // early answers wait
    QVERIFY(link.take(33, SlowUpdate::whenReady, model));
    link.post(33, 6);
    for (std::uint64_t n = 34; n < 200; ++n)
        QVERIFY(!link.take(n, SlowUpdate::whenReady, model)); // nobody steps it
    QVERIFY(model.step());
    QVERIFY(link.take(200, SlowUpdate::whenReady, model));
    QCOMPARE(link.answer(), 12);
}

void TestTwoRates::aReplayAppliesWhereItWasRecorded() {
    SlowLink<int, int> link({33, 33});
    Doubler model(link);
    QVERIFY(!link.take(0, SlowUpdate::now, model)); // nothing was asked
    link.post(0, 7);
    QVERIFY(!link.take(50, SlowUpdate::notNow, model));
    QVERIFY(link.take(51, SlowUpdate::now, model));
    QCOMPARE(link.answer(), 14);
    QVERIFY(!link.take(52, SlowUpdate::now, model));
}

void TestTwoRates::oneRequestAtATime() {
    SlowLink<int, int> link({10, 10});
    Doubler model(link);
    link.post(0, 1);
    for (std::uint64_t n = 1; n < 100; ++n)
        QVERIFY(!link.mayPost(n)); // however long it takes
    QVERIFY(model.step());
    QVERIFY(link.take(100, SlowUpdate::whenReady, model));
    QVERIFY(link.mayPost(100)); // the period is over
    link.post(100, 2);
    QVERIFY(model.step() && link.take(110, SlowUpdate::whenReady, model));
    QVERIFY(link.mayPost(110));
}

void TestTwoRates::theBlendIsContinuousAtEveryApplication() {
    core::Random random(3);
    AnswerBlend blend(33, 0.5);
    std::array<double, 16> answers{};
    blend.reset(0);
    std::uint64_t n = 0, asked = 0;
    double before = 0.0, largest = 0.0;
    for (std::uint64_t number = 1; number < 400; ++number) {
        asked = n;
        n += 33 + random.below(90);
        for (std::uint64_t tick = asked + 1; tick <= n; ++tick) {
            const double now = at(blend, tick, answers);
            largest = std::max(largest, std::abs(now - before));
            before = now;
        }
        answers[number % 16] = random.uniform(-1.0, 1.0);
        blend.apply(n, asked, number);
        QVERIFY(std::abs(at(blend, n, answers) - before) < 1e-12); // value at the application: the same
    }
    // |P_k - P_k-1| <= (1 + 2γ) · 2, |A(k) - A(k-1)| <= 2, B = 33 and no two requests nearer than 33 ticks.
    const double bound = 1.5 / 33.0 * (1.0 + 2.0 * 0.5) * 2.0 + 0.5 * 2.0 / 33.0;
    QVERIFY2(largest < bound && largest > 0.1 * bound,
             qPrintable(QString("%1 of %2").arg(largest).arg(bound)));
}

void TestTwoRates::weightsSumToOneAndThePredictionIsLimited() {
    AnswerBlend blend(33, 0.5);
    blend.reset(0);
    QCOMPARE(blend.weights(500).newest, 1.0);
    blend.apply(40, 5, 1);
    blend.apply(80, 42, 2);
    for (std::uint64_t n = 80; n < 2'000; ++n) {
        const BlendWeights w = blend.weights(n);
        QVERIFY(std::abs(w.newest + w.previous + w.before - 1.0) < 1e-12);
        QVERIFY(w.newest <= 1.5 && w.previous >= -0.5); // half an interval ahead, however late the next one
    }
    QCOMPARE(blend.weights(2'000).newest, 1.5);
    QCOMPARE(blend.weights(2'000).before, 0.0);
}

void TestTwoRates::noStepIsFelt() {
    // What a tick can change, with k of the local model, U = x k/(k + K) the most that the organ gives way,
    // and no friction:
    //   k (|Δx_tool| + (1.5/B)(1 + 2γ) U + γ U/B) along the normal; the direction turns with the foot, f |Δx|
    //   kFollow/R at most; the damper b sees at most the surface's speed, which is continuous but for the
    //   ends of the prediction: b γ U/(B T).
    const SphereApexParameters p = softDome();
    const double k = p.stiffnessLow_N_per_m;
    const double given =
        (kDepth_m + 0.0015) * k / (k + p.organStiffness_N_per_m); // the slide adds depth on the flank
    const double surface = (1.5 / 33.0 * 2.0 + 0.5 / 33.0) * given;
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        const Slide shown = slide(true, seed);
        const double bound = k * (shown.fastest_m + surface) +
                             shown.largestForce_N * shown.fastest_m * 2.0 / p.radius_m +
                             p.damping_Ns_per_m * 0.5 * given / 0.033;
        const Slide bare = slide(false, seed);
        qInfo("seed %d: %d answers, up to %d ticks apart; largest change a tick %.3f N (bound %.3f N), "
              "without blending %.3f N",
              static_cast<int>(seed), shown.applied, static_cast<int>(shown.longestGap), shown.largestStep_N,
              bound, bare.largestStep_N);
        QVERIFY(shown.applied > 100 && shown.longestGap > 100);
        QVERIFY(shown.largestForce_N > 0.5);
        QVERIFY(shown.largestStep_N < bound);
        QVERIFY(bare.largestStep_N > bound); // so that the test can fail
    }
}

void TestTwoRates::aQuickPressIsLocalALastingOneTheSeries() {
    const SphereApexParameters p = softDome();
    auto dome = std::move(*TouchedDome::make(p, planSphereApexTrials(p, 1)));
    dome->begin(0, 0);
    const double k = p.stiffnessLow_N_per_m, organ = p.organStiffness_N_per_m;
    const Vec3 deep(0.0, 0.0, p.radius_m - 0.002);
    double first = 0.0, last = 0.0;
    for (std::uint64_t n = 0; n < 4'000; ++n) {
        dome->update(n, SlowUpdate::asDue);
        const double f = dome->respond(0, n < 10 ? Vec3(0, 0, 0.025) : deep, Vec3::Zero()).force.z();
        dome->ask(n);
        first = n == 10 ? f : first;
        last = f;
    }
    QVERIFY2(std::abs(first - k * 0.002) < 1e-3 * first, qPrintable(QString::number(first)));
    // The foot settles inside a triangle of the dent, where the network is a little stiffer than at its
    // reference vertex.
    QVERIFY2(std::abs(last - 0.002 * k * organ / (k + organ)) < 0.01 * last,
             qPrintable(QString::number(last)));
}

void TestTwoRates::anotherTrialBeginsAtRest() {
    const SphereApexParameters p = softDome();
    auto dome = std::move(*TouchedDome::make(p, planSphereApexTrials(p, 1)));
    dome->begin(0, 0);
    const auto press = [&](std::uint64_t from, int ticks) {
        std::vector<double> forces;
        for (std::uint64_t n = from; n < from + static_cast<std::uint64_t>(ticks); ++n) {
            dome->update(n, SlowUpdate::asDue);
            forces.push_back(dome->respond(0, Vec3(0.001, 0.0, 0.018), Vec3::Zero()).force.z());
            dome->ask(n);
        }
        return forces;
    };
    const auto first = press(0, 990);
    dome->begin(0, 990); // an answer of the old trial is on its way
    const auto second = press(990, 990);
    QCOMPARE(second.front(), first.front());
    QVERIFY(std::abs(second.back() - first.back()) < 1e-3 * first.back());
    for (std::size_t n = 0; n < 33; ++n)
        QCOMPARE(second[n], first.front()); // nothing of the old dent
}

// Searches on the moved surface go by it: no vertex is farther from its rest, and the bound stays near what
// is shown, however long the organ has moved.
void TestTwoRates::theLargestDisplacementBoundsWhatIsShown() {
    const SphereApexParameters p = softDome();
    auto dome = std::move(*TouchedDome::make(p, planSphereApexTrials(p, 1)));
    dome->begin(0, 0);
    const DeformableOrgan& organ = *dome->organ();
    const auto farthest_m = [&] {
        double most = 0.0;
        for (std::uint32_t v = 0; v < dome->mesh().vertices().size(); ++v)
            most = std::max(most, (organ.position(v) - organ.restMesh().position(v)).norm());
        return most;
    };
    QCOMPARE(organ.largestDisplacement_m(), 0.0);
    double shown_m = 0.0;
    for (std::uint64_t n = 0; n < 2'000; ++n) {
        dome->update(n, SlowUpdate::asDue);
        if (n % 50 == 49) {
            shown_m = farthest_m();
            QVERIFY(shown_m <= organ.largestDisplacement_m() + 1e-12);
        }
        dome->respond(0, Vec3(0.001, 0.0, n < 200 ? 0.025 : 0.018), Vec3::Zero());
        dome->ask(n);
    }
    QVERIFY2(shown_m > 2e-4, qPrintable(QString::number(shown_m)));
    // The last answers are alike; with |weights| of at most 1 + 2γ it is twice what is shown.
    QVERIFY2(organ.largestDisplacement_m() < 2.5 * shown_m,
             qPrintable(QString::number(organ.largestDisplacement_m())));
    dome->begin(0, 2'000);
    QCOMPARE(organ.largestDisplacement_m(), 0.0);
    QCOMPARE(farthest_m(), 0.0);
}

// P2: "after a visual loop update, the haptic loop compares predicted values". Untouched there is nothing to
// compare; a tool that rests is predicted ever better; one that presses is predicted worse than one that
// rests.
void TestTwoRates::thePredictionIsComparedWithWhatCame() {
    const SphereApexParameters p = softDome();
    auto dome = std::move(*TouchedDome::make(p, planSphereApexTrials(p, 1)));
    dome->begin(0, 0);
    std::vector<double> pressing, held, resting;
    for (std::uint64_t n = 0; n < 4000; ++n) {
        const double depth = n < 200    ? -0.01
                             : n < 1500 ? 0.004 * static_cast<double>(n - 200) / 1300.0
                                        : 0.004;
        const bool applied = dome->update(n, SlowUpdate::asDue);
        const PredictionError error = dome->organ()->predictionError();
        if (n < 200)
            QVERIFY(error.predicted_m == 0.0 && error.held_m == 0.0);
        if (applied && n > 400 && n < 1500) {
            pressing.push_back(error.predicted_m);
            held.push_back(error.held_m);
        }
        if (applied && n > 3500)
            resting.push_back(error.predicted_m);
        dome->respond(0, Vec3(0.0, 0.0, 0.020 - depth), Vec3::Zero());
        dome->ask(n);
    }
    const auto mean = [](const std::vector<double>& v) {
        return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
    };
    QVERIFY(pressing.size() > 10 && resting.size() > 5);
    QVERIFY2(mean(pressing) > 1e-6 && mean(pressing) < 1e-3, qPrintable(QString::number(mean(pressing))));
    QVERIFY2(mean(resting) < 0.05 * mean(pressing), qPrintable(QString::number(mean(resting))));
    QVERIFY2(
        mean(pressing) < mean(held),
        qPrintable(QStringLiteral("%1 of %2").arg(mean(pressing)).arg(mean(held)))); // what prediction is for
    std::printf("pressing: predicted %.1f µm, held %.1f µm; resting %.2f µm\n", 1e6 * mean(pressing),
                1e6 * mean(held), 1e6 * mean(resting));
    dome->begin(0, 4000);
    QCOMPARE(dome->organ()->predictionError().predicted_m, 0.0);
}

void TestTwoRates::settingsAreTakenUpToTheirBounds() {
    const SphereApexParameters p = softDome();
    const auto dome = std::move(*TouchedDome::make(p, planSphereApexTrials(p, 1)));
    const TriangleMesh& mesh = dome->mesh();
    std::vector<bool> anchored(mesh.vertices().size(), true);
    std::uint32_t highest = 0;
    for (std::uint32_t i = 0; i < mesh.vertices().size(); ++i)
        if (mesh.position(i).z() > mesh.position(highest).z())
            highest = i;
    anchored[highest] = false;
    const auto takes = [&](auto change) {
        DeformableOrgan::Settings settings;
        settings.timing = {40, 33};
        settings.blend_ticks = 33;
        change(settings);
        const auto made = DeformableOrgan::create(mesh, anchored, highest, settings);
        return made || made.error().code != core::ErrorCode::badInput
                   ? QStringLiteral("taken")
                   : QString::fromStdString(made.error().message);
    };
    using Settings = DeformableOrgan::Settings;
    const QString taken = QStringLiteral("taken");
    QCOMPARE(takes([](Settings&) {}), taken);
    for (const double prediction : {0.0, 1.0})
        QCOMPARE(takes([=](Settings& s) { s.prediction = prediction; }), taken);
    for (const double prediction : {-1e-9, 1.0 + 1e-9, double(NAN)})
        QVERIFY(takes([=](Settings& s) {
                    s.prediction = prediction;
                }).contains(QStringLiteral("prediction of 0 to 1")));
    QCOMPARE(takes([](Settings& s) { s.blend_ticks = 1; }), taken);
    QCOMPARE(takes([](Settings& s) { s.timing.period_ticks = 1; }), taken);
    QVERIFY(takes([](Settings& s) { s.blend_ticks = 0; }) != taken);
    QVERIFY(takes([](Settings& s) {
                s.blend_ticks = 34;
            }).contains(QStringLiteral("a blend of 34 ticks at a latency of 33")));
    QVERIFY(takes([](Settings& s) { s.timing.period_ticks = 0; }) != taken);
}

QTEST_APPLESS_MAIN(TestTwoRates)
#include "test_two_rates.moc"
