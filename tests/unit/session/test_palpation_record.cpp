// SPDX-License-Identifier: GPL-3.0-or-later
// A palpation looked back at: maps rebuilt from recorded poses and forces, what became of findings, sessions
// pooled.
#include "../scoring/palpation_traces.h"
#include "app/exercises/palpation/session/detection_record.h"
#include "app/exercises/palpation/session/palpation_record.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "simulation/palpation/tissue_surface.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Vec3;
using scoring::TrialTrace;
using tests::MadeTrial;

namespace {

simulation::PalpationParameters flatLevel() {
    simulation::PalpationParameters level;
    level.areaHalf_m = {0.03, 0.03};
    return level;
}

/// The finger pressed at these places, one a sample from the 10th on, 2 mm deep.
TrialTrace pressedAt(const std::vector<std::pair<core::Vec2, Vec3>>& presses) {
    TrialTrace trial = MadeTrial({{0.0, 0.0}}).found(0, 0.001, 0.0, 4);
    std::size_t i = 10;
    for (const auto& [xy_m, force_N] : presses) {
        trial.tools[0].p_WT_m[i] = {xy_m.x(), xy_m.y(), -0.002};
        trial.tools[0].tissue_N[i++] = force_N;
    }
    return trial;
}

bool sameMap(const simulation::SurfaceMap& a, const simulation::SurfaceMap& b) {
    for (int row = 0; row < simulation::SurfaceMap::kRows; ++row)
        for (int column = 0; column < simulation::SurfaceMap::kColumns; ++column)
            if (a.force_N(column, row) != b.force_N(column, row))
                return false;
    return true;
}

/// A track of the same presses: a sample each 4 ms.
session::PlaybackTrack trackOf(const TrialTrace& trial) {
    session::PlaybackTrack track;
    track.toolCount = 1;
    for (std::size_t i = 0; i < trial.tools[0].t_s.size(); ++i) {
        session::PlaybackMoment moment;
        moment.t_s = trial.tools[0].t_s[i];
        moment.phase = core::TrialPhase::running;
        track.moments.push_back(moment);
        session::PlaybackTool tool;
        tool.p_WT = trial.tools[0].p_WT_m[i];
        tool.tissue_N = trial.tools[0].tissue_N[i];
        track.tools.push_back(tool);
    }
    session::PlaybackTrial whole;
    whole.end_s = track.moments.back().t_s;
    track.trials.push_back(whole);
    return track;
}

} // namespace

class TestPalpationRecord : public QObject {
    Q_OBJECT
private slots:
    /// The map has the normal part of each press where the pad lay, as if the scene had pressed it; the
    /// lateral part, pauses, and poses above the surface leave no trace.
    void mapOfPresses() {
        const auto level = flatLevel();
        auto trial = pressedAt({{{0.01, 0.0}, {0.3, 0.0, 1.0}},
                                {{-0.01, 0.01}, {0.0, 0.0, 2.0}},
                                {{0.02, 0.02}, {0.0, 0.0, 3.0}}});
        trial.tools[0].paused[12] = 1; // the third
        simulation::SurfaceMap expected = session::emptyMapOf(level);
        expected.press({0.01, 0.0}, 1.0);
        expected.press({-0.01, 0.01}, 2.0);
        QVERIFY(expected.coverage() > 0.0);
        QVERIFY(sameMap(session::mapOf(level, trial), expected));
        trial.tools[0].tissue_N[11] = Vec3(0.0, 0.0, std::nan(""));
        trial.tools[0].p_WT_m[10].z() = 0.001;
        QVERIFY(sameMap(session::mapOf(level, trial), session::emptyMapOf(level)));
    }

    /// On a dome the force is split along the surface's own normal, and the place is the foot, not what lies
    /// straight above.
    void mapOnADome() {
        auto level = flatLevel();
        level.tissue.shape.bumps = {{{0.0, 0.0}, {0.04, 0.04}, 0.0, 0.012}};
        const simulation::TissueSurface surface(level.tissue.shape);
        const core::Vec2 place(0.012, -0.008);
        const Vec3 normal = surface.normalAt(place);
        auto trial = pressedAt({{place, 1.5 * normal}});
        trial.tools[0].p_WT_m[10] = surface.pointAt(place) - 0.003 * normal;
        simulation::SurfaceMap expected = session::emptyMapOf(level);
        expected.press(place, 1.5);
        const auto map = session::mapOf(level, trial);
        QVERIFY(std::abs(map.coverage() - expected.coverage()) < 1e-12);
        const int column = static_cast<int>((place.x() + 0.03) / 0.06 * simulation::SurfaceMap::kColumns);
        const int row = static_cast<int>((place.y() + 0.03) / 0.06 * simulation::SurfaceMap::kRows);
        QVERIFY(std::abs(map.force_N(column, row) - 1.5) < 1e-6);
    }

    void mapOfATrackGrows() {
        const auto level = flatLevel();
        const auto trial = pressedAt({{{0.01, 0.0}, {0.0, 0.0, 1.0}}, {{-0.01, 0.01}, {0.0, 0.0, 2.0}}});
        const auto track = trackOf(trial);
        QVERIFY(sameMap(session::mapAt(level, track, 0, 0.05), session::emptyMapOf(level)));
        simulation::SurfaceMap first = session::emptyMapOf(level);
        first.press({0.01, 0.0}, 1.0);
        QVERIFY(sameMap(session::mapAt(level, track, 0, 0.1), first)); // the 10th sample
        QVERIFY(sameMap(session::mapAt(level, track, 0, 3.0), session::mapOf(level, trial)));
        QVERIFY(sameMap(session::mapAt(level, track, 1, 3.0), session::emptyMapOf(level))); // no such trial
    }

    void records() {
        TrialTrace trial = pressedAt({{{0.01, 0.0}, {0.0, 0.0, 1.0}}});
        trial.quantities[7].values.back() = 0.25;
        const auto records = session::palpationRecord(
            tests::palpationSession({trial, MadeTrial({{0.01, 0.0}}).timedOut()}), flatLevel());
        QVERIFY(records);
        QCOMPARE(records->size(), std::size_t{2});
        const auto& first = records->front();
        QVERIFY(first.completed && !first.timedOut && (*records)[1].timedOut);
        QCOMPARE(first.coverage, 0.25);
        QCOMPARE(first.answer.hits(), 1);
        QCOMPARE((*records)[1].answer.misses(), 1);
        QVERIFY(first.map.coverage() > 0.0 && (*records)[1].map.coverage() == 0.0);
    }

    void failureNamesTheTrial() {
        TrialTrace bare = MadeTrial();
        bare.quantities.clear();
        const auto records =
            session::palpationRecord(tests::palpationSession({MadeTrial(), bare}), flatLevel());
        QVERIFY(!records);
        QCOMPARE(records.error().message, std::string("trial 2: the trace has no reports"));
    }

    void sessionsArePooled() {
        session::PooledDetection pooled;
        TrialTrace bare = MadeTrial({{0.0, 0.0}});
        bare.quantities.clear();
        session::addDetection(pooled,
                              tests::palpationSession({MadeTrial({{0.0, 0.0}}).found(0, 0.0, 0.0, 5), bare}));
        session::addDetection(pooled,
                              tests::palpationSession({MadeTrial({{0.0, 0.0}}).found(0, -0.02, -0.02, 2)}));
        QCOMPARE(pooled.sessions, 2);
        QCOMPARE(pooled.trials, 2);
        QCOMPARE(pooled.unjudged, 1);
        QVERIFY((pooled.counts() == core::DetectionCounts{1, 2, 1, 16}));
        QCOMPARE(pooled.ratings.ofSignal[0], 1); // sure
        QCOMPARE(pooled.ratings.ofNoise[3], 1);  // confidence 2
    }

    /// All levels together: not where lumps are drawn, never where a control acts.
    void whichLevelsTellDetection() {
        const session::DetectionQuery all, first{0, 1, true, ""};
        catalogue::ExerciseLevel level;
        level.cues = {"object", "tool"};
        level.parameters = flatLevel();
        QVERIFY(!session::tellsDetection(level, all) && session::tellsDetection(level, first));
        level.cues = {"tool"};
        QVERIFY(session::tellsDetection(level, all));
        auto controlled = flatLevel();
        controlled.control.forceOff = true;
        level.parameters = controlled;
        QVERIFY(!session::tellsDetection(level, all) && !session::tellsDetection(level, first));
        controlled.control = {};
        controlled.control.moveAfter_s = 5.0;
        level.parameters = controlled;
        QVERIFY(!session::tellsDetection(level, all) && !session::tellsDetection(level, first));
        level.parameters = simulation::SphereApexParameters{};
        QVERIFY(!session::tellsDetection(level, all));
    }

    void bandsOfTheLevel() {
        auto level = flatLevel();
        level.coverForce_N = 0.4;
        level.maximumForce_N = 3.0;
        QVERIFY((session::mapBandsOf(level) == simulation::MapBands{0.4, 0.8, 2.5, 3.0}));
    }
};

QTEST_APPLESS_MAIN(TestPalpationRecord)
#include "test_palpation_record.moc"
