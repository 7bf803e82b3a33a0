// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/rendered_run.h"
#include "support/study_designs.h"

#include <QtTest>

#include <cmath>
#include <cstdio>

using namespace chiron;

namespace {

constexpr int kExplorations = 200;

/// σ_render over the table, from noiseless explorations (psychophysics.md §6).
double renderingSd(const psychophysics::StudyDesign& design) {
    double squares = 0.0;
    int levels = 0;
    for (const int candidate : {5, 12, 20}) {
        const auto noise = session::renderingNoise(design, "main", candidate, kExplorations / 3, 17);
        if (!noise)
            return -1.0;
        squares += noise->pooledSd * noise->pooledSd;
        ++levels;
    }
    return std::sqrt(squares / levels);
}

} // namespace

class TestRenderedStudyLong : public QObject {
    Q_OBJECT
private slots:
    /// 200 seeded runs through the rendering: truth is √(σ² + σ_render²), inside the 95 % interval in at
    /// least 90 %.
    void truthIsInsideInNineOfTen() {
        session::RenderedRunRequest request;
        request.design = testing::rank3Study();
        request.condition = "main";
        request.observer = {.weber = 0.12, .lapse = 0.02};
        const double rendering = renderingSd(request.design);
        QVERIFY(rendering >= 0.0);
        const double truth = std::hypot(psychophysics::sigmaOf(request.observer), rendering);
        int inside = 0;
        for (int seed = 1; seed <= 200; ++seed) {
            request.seed = static_cast<std::uint64_t>(seed);
            const auto run = session::runRendered(request);
            QVERIFY(run);
            inside += run->estimate.sigma95.low <= truth && truth <= run->estimate.sigma95.high ? 1 : 0;
        }
        std::printf("inside the 95 %% interval: %d of 200 (truth %.4f, rendering %.4f)\n", inside, truth,
                    rendering);
        QVERIFY(inside >= 180);
    }
    /// P2's descending rule stops where a participant first fails: its last passed difference lies above the
    /// JND.
    void descendingRuleIsBiased() {
        session::RenderedRunRequest request;
        request.design = testing::descendingStudy();
        request.condition = "main";
        request.observer = {.weber = 0.12, .lapse = 0.02};
        const double jnd = std::log10(1.0 + request.observer.weber);
        double sum = 0.0;
        int known = 0;
        for (int seed = 1; seed <= 40; ++seed) {
            request.seed = static_cast<std::uint64_t>(seed);
            const auto run = session::runRendered(request);
            QVERIFY(run);
            if (run->threshold > 0.0) {
                sum += std::log10(run->threshold / jnd);
                ++known;
            }
        }
        QVERIFY(known > 30);
        const double bias = sum / known;
        std::printf("descending rule: log10 of its threshold over the 75 %% JND %+.3f (%d runs)\n", bias,
                    known);
        QVERIFY(bias > 0.1 && bias < 0.6);
    }
};

QTEST_MAIN(TestRenderedStudyLong)
#include "test_rendered_study_long.moc"
