// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/palpation/simulation/palpation_plan.h"

#include <QtTest>
#include <algorithm>
#include <set>

using namespace chiron;
using namespace chiron::simulation;

namespace {

constexpr int kSeeds = 1000;

PalpationParameters severalInABreast() {
    PalpationParameters p;
    p.kinds = {{0.0075, 0.014, 10.0, 5}, {0.005, 0.012, 10.0, 5}, {0.0075, 0.014, 3.0, 2}};
    p.depthSpread_m = 0.0015;
    p.lumpsLow = 1;
    p.lumpsHigh = 3;
    p.catchTrials = 2;
    p.trials = 6;
    p.areaHalf_m = {0.045, 0.045};
    p.tissue.regions = {{"areola", {0.0, 0.0}, {0.012, 0.012}, 0.0, 0.4}};
    return p;
}

void keepsItsConstraints(const PalpationParameters& p, const PalpationTrial& trial) {
    std::set<int> regions;
    for (int i = 0; i < trial.lumps; ++i) {
        const Lump& lump = trial.lump[static_cast<std::size_t>(i)];
        const int region = palpationRegion(p, lump.place_m);
        QVERIFY(region >= 0);
        QVERIFY(regions.insert(region).second); // one a region
        const core::Vec2 off = (lump.place_m - palpationRegionMiddle_m(p, region)).cwiseAbs();
        QVERIFY(off.x() <= (0.5 - kRegionInset) * 2.0 * p.areaHalf_m.x() / p.regionColumns + 1e-9);
        QVERIFY(off.y() <= (0.5 - kRegionInset) * 2.0 * p.areaHalf_m.y() / p.regionRows + 1e-9);
        for (int k = 0; k < i; ++k)
            QVERIFY((trial.lump[static_cast<std::size_t>(k)].place_m - lump.place_m).norm() >= p.spacing_m);
        for (const StiffRegion& distractor : p.tissue.regions)
            QVERIFY((distractor.centre_m - lump.place_m).norm() >= p.spacing_m);
        QVERIFY(lump.radius_m <= 0.75 * lump.depth_m + 1e-12);
        const auto kind = std::find_if(p.kinds.begin(), p.kinds.end(), [&](const LumpKind& one) {
            return one.radius_m == lump.radius_m && one.ratio == lump.ratio &&
                   std::abs(one.depth_m - lump.depth_m) <= p.depthSpread_m + 1e-12;
        });
        QVERIFY(kind != p.kinds.end());
        QCOMPARE(trial.hardness[static_cast<std::size_t>(i)], kind->hardness);
    }
}

} // namespace

/// What is drawn for a palpation.
class TestPalpationPlan : public QObject {
    Q_OBJECT
private slots:
    void thousandSeedsKeepTheConstraints() {
        const PalpationParameters p = severalInABreast();
        std::array<int, 4> lumps{};
        std::array<int, 6> catches{};
        std::set<double> kinds;
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
            const auto trials = planPalpationTrials(p, seed);
            QCOMPARE(trials.size(), std::size_t{6});
            QCOMPARE(std::count_if(trials.begin(), trials.end(),
                                   [](const PalpationTrial& t) { return t.lumps == 0; }),
                     2);
            for (std::size_t i = 0; i < trials.size(); ++i) {
                keepsItsConstraints(p, trials[i]);
                if (QTest::currentTestFailed())
                    return;
                ++lumps[static_cast<std::size_t>(trials[i].lumps)];
                catches[i] += trials[i].lumps == 0 ? 1 : 0;
            }
        }
        // 4000 draws of 1..3 and 6000 of the places of two catch trials: 5 standard deviations either way.
        for (int n = 1; n <= 3; ++n)
            QVERIFY(std::abs(lumps[static_cast<std::size_t>(n)] - 4000.0 / 3.0) < 150.0);
        for (const int here : catches)
            QVERIFY(std::abs(here - 1000.0 / 3.0) < 75.0);
    }

    /// A level that teaches begins with a lump; the empty trials are drawn among the others, and nothing else
    /// changes.
    void anIntroductionHasALump() {
        PalpationParameters p = severalInABreast();
        p.lumpsLow = 0; // even where a trial may come out empty by itself
        PalpationParameters introduced = p;
        introduced.lumpFirst = true;
        std::array<int, 6> catches{};
        bool wouldHaveBeenEmpty = false;
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
            const auto trials = planPalpationTrials(introduced, seed);
            const auto plain = planPalpationTrials(p, seed);
            wouldHaveBeenEmpty = wouldHaveBeenEmpty || plain[0].lumps == 0;
            for (std::size_t i = 0; i < trials.size(); ++i) {
                keepsItsConstraints(introduced, trials[i]);
                if (QTest::currentTestFailed())
                    return;
                QCOMPARE(trials[i].introduction, i == 0);
                QVERIFY(!plain[i].introduction);
            }
            QVERIFY(trials[0].lumps >= 1);
        }
        QVERIFY(wouldHaveBeenEmpty);
        introduced.lumpsLow = p.lumpsLow = 1;
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
            const auto trials = planPalpationTrials(introduced, seed);
            QCOMPARE(std::count_if(trials.begin(), trials.end(),
                                   [](const PalpationTrial& t) { return t.lumps == 0; }),
                     2);
            for (std::size_t i = 0; i < trials.size(); ++i)
                catches[i] += trials[i].lumps == 0 ? 1 : 0;
        }
        QCOMPARE(catches[0], 0);
        for (std::size_t i = 1; i < catches.size(); ++i)
            QVERIFY(std::abs(catches[i] - 1000.0 * 2.0 / 5.0) < 80.0); // two of five, 5 standard deviations
        introduced.catchTrials = introduced.trials - 1;                // the only one that is not empty
        const auto trials = planPalpationTrials(introduced, 7);
        QVERIFY(trials[0].lumps >= 1 && std::all_of(trials.begin() + 1, trials.end(),
                                                    [](const PalpationTrial& t) { return t.lumps == 0; }));
    }

    // What the control moves is at a good place before and after.
    void movedPlacesKeepThemToo() {
        PalpationParameters p = severalInABreast();
        p.lumpsHigh = 1;
        p.control.moveAfter_s = 10.0;
        p.control.move_m = {0.03, 0.0};
        int lumps = 0;
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
            for (PalpationTrial trial : planPalpationTrials(p, seed)) {
                lumps += trial.lumps;
                keepsItsConstraints(p, trial);
                for (Lump& lump : trial.lump)
                    lump.place_m = palpationMovedPlace_m(p, lump.place_m);
                keepsItsConstraints(p, trial);
                if (QTest::currentTestFailed())
                    return;
            }
        QCOMPARE(lumps, 4 * kSeeds);
    }

    void theSameSeedTheSameTrials() {
        const PalpationParameters p = severalInABreast();
        const auto one = planPalpationTrials(p, 7);
        const auto same = planPalpationTrials(p, 7);
        const auto other = planPalpationTrials(p, 8);
        bool differs = false;
        for (std::size_t i = 0; i < one.size(); ++i) {
            QCOMPARE(one[i].lumps, same[i].lumps);
            differs = differs || one[i].lumps != other[i].lumps;
            for (int k = 0; k < one[i].lumps; ++k) {
                const auto at = static_cast<std::size_t>(k);
                QCOMPARE(one[i].lump[at].place_m, same[i].lump[at].place_m);
                QCOMPARE(one[i].lump[at].depth_m, same[i].lump[at].depth_m);
                differs = differs || one[i].lump[at].place_m != other[i].lump[at].place_m;
            }
        }
        QVERIFY(differs);
    }

    // Depths and kinds have streams of their own: what is drawn of one leaves the others.
    void streamsAreApart() {
        PalpationParameters p = severalInABreast();
        const auto before = planPalpationTrials(p, 3);
        p.kinds = {{0.005, 0.012, 4.0, 2}};
        p.depthSpread_m = 0.0;
        const auto after = planPalpationTrials(p, 3);
        for (std::size_t i = 0; i < before.size(); ++i) {
            QCOMPARE(after[i].lumps, before[i].lumps);
            for (int k = 0; k < before[i].lumps; ++k)
                QCOMPARE(after[i].lump[static_cast<std::size_t>(k)].place_m,
                         before[i].lump[static_cast<std::size_t>(k)].place_m);
        }
    }

    // As many lumps as there are regions are still drawn; no lump stands in a middle because it has to.
    void everyRegionMayHaveALump() {
        PalpationParameters p = severalInABreast();
        p.tissue.regions.clear();
        p.regionColumns = 2;
        p.regionRows = p.catchTrials = 1;
        p.lumpsLow = p.lumpsHigh = 2;
        p.spacing_m = 0.001;
        for (std::uint64_t seed = 0; seed < 50; ++seed)
            for (const PalpationTrial& trial : planPalpationTrials(p, seed)) {
                keepsItsConstraints(p, trial);
                QVERIFY(trial.lumps == 0 || trial.lumps == 2);
                for (int i = 0; i < trial.lumps; ++i) {
                    const core::Vec2& place_m = trial.lump[static_cast<std::size_t>(i)].place_m;
                    QVERIFY((place_m - palpationRegionMiddle_m(p, palpationRegion(p, place_m))).norm() >
                            1e-9);
                }
            }
    }

    // Where a draw cannot succeed, middles of regions are the last resort, and it is known how many they
    // hold.
    void lastResortHoldsWhatItSays() {
        PalpationParameters p = severalInABreast();
        QCOMPARE(mostPalpationLumps(p),
                 6); // eight regions round the distractor, of which a trial has six at most
        p.regionColumns = p.regionRows = p.lumpsHigh = 1;
        p.spacing_m = 0.05; // four distractors leave a micrometre round the middle: no draw finds it
        for (const core::Vec2& way :
             {core::Vec2(1.0, 0.0), core::Vec2(-1.0, 0.0), core::Vec2(0.0, 1.0), core::Vec2(0.0, -1.0)})
            p.tissue.regions.push_back({"", 0.050001 * way, {0.01, 0.01}, 0.0, 0.3});
        p.tissue.regions.erase(p.tissue.regions.begin());
        QCOMPARE(mostPalpationLumps(p), 1);
        for (std::uint64_t seed = 0; seed < 50; ++seed)
            for (const PalpationTrial& trial : planPalpationTrials(p, seed))
                QVERIFY(trial.lumps == 0 || trial.lump[0].place_m.norm() < 1e-9);
        p = severalInABreast();
        p.spacing_m = 0.2; // no room for a second, none for one beside the distractor
        QCOMPARE(mostPalpationLumps(p), 0);
        for (const PalpationTrial& trial : planPalpationTrials(p, 1))
            QCOMPARE(trial.lumps, 0);
    }

    void regionsCoverTheArea() {
        const PalpationParameters p = severalInABreast();
        for (int region = 0; region < 9; ++region)
            QCOMPARE(palpationRegion(p, palpationRegionMiddle_m(p, region)), region);
        QCOMPARE(palpationRegion(p, {-0.045, -0.045}), 0);
        QCOMPARE(palpationRegion(p, {0.045, 0.045}), 8);
        QCOMPARE(palpationRegion(p, {0.0451, 0.0}), -1);
        QCOMPARE(palpationRegion(p, {0.0, std::nan("")}), -1);
    }
};

QTEST_APPLESS_MAIN(TestPalpationPlan)
#include "test_palpation_plan.moc"
