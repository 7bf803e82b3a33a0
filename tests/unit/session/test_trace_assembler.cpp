// SPDX-License-Identifier: GPL-3.0-or-later
#include "frames.h"
#include "modules/exercises/urethra_insertion/cues/procedure_bits.h"
#include "session/trace_assembler.h"
#include "session/trace_mark.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using tests::MillimetreCounts;
using tests::someFrames;
namespace bits = core::event_bits;

class TestTraceAssembler : public QObject {
    Q_OBJECT
private slots:
    void trialIsCutAtItsEvents();
    void timedOutTrial();
    void unmarkedTrialStays();
    void markOfATraceEndIsNone();
    void chunksMakeNoDifference();
    void pausedSamplesAreFlagged();
    void packetReadTwiceIsOneSample();
    void markOnARepeatedPacketCounts();
    void refusedPacketsAreLeftOut();
    void storedGrids();
    void contactAtTheMark();
    void measuredForceOnlyWhereMeasured();
    void everyToolHasItsTrace();
    void completedTrial();
    void orientationAndTorqueOfToolsThatTurn();
    void orientationAndTorqueFollowTheSamples();

private:
    /// The first tool turns about x by its fourth count, in degrees; the second cannot turn.
    class Turning final : public session::IOrientationOf {
    public:
        bool turns(int tool) const noexcept override { return tool == 0; }
        core::Quat q_WT(int, const core::ToolFrame& frame) const noexcept override {
            return core::Quat(Eigen::AngleAxisd(0.017453292519943295 * frame.counts[3], core::Vec3::UnitX()));
        }
    };

    static std::vector<scoring::TrialTrace> assemble(const std::vector<core::HapticFrame>& frames,
                                                     int tools = 1,
                                                     const session::IOrientationOf* orientations = nullptr) {
        const MillimetreCounts positions;
        session::TraceAssembler assembler(positions, tools, orientations);
        assembler.add(frames);
        return assembler.takeTrials();
    }
};

void TestTraceAssembler::trialIsCutAtItsEvents() {
    auto frames = someFrames(20);
    frames[3].header.events = bits::kTrialStarted;
    frames[7].header.events = bits::kMarked;
    frames[12].header.events = bits::kTrialStarted;
    frames[12].header.trial = 1;
    frames[15].header.events = bits::kMarked;
    const auto trials = assemble(frames);
    QCOMPARE(trials.size(), std::size_t{2});
    QCOMPARE(trials[0].tools[0].t_s,
             (std::vector<double>{0.003, 0.004, 0.005, 0.006, 0.007})); // both ends included
    QCOMPARE(trials[0].tools[0].p_WT_m.front().x(), 0.003);
    QCOMPARE(trials[0].p_WMark_m.x(), 0.007);
    QVERIFY(trials[0].marked && !trials[0].timedOut);
    QCOMPARE(trials[0].trial, 0);
    QCOMPARE(trials[1].trial, 1);
    QCOMPARE(trials[1].tools[0].t_s.size(), std::size_t{4});
    QCOMPARE(trials[1].tools[0].t_s.front(), 0.012); // since the session's first frame, not the trial's
}

void TestTraceAssembler::refusedPacketsAreLeftOut() {
    auto frames = someFrames(12);
    frames[2].header.events = bits::kTrialStarted;
    frames[9].header.events = bits::kMarked;
    for (const std::size_t bad :
         {std::size_t{0}, std::size_t{5}, std::size_t{9}}) { // first frame, mid-trial, at the mark
        frames[bad].tool[0].counts = {900, 900, 900};
        frames[bad].tool[0].deviceTime_us =
            4'000'000'000; // a clock that jumped: later good packets are not older than it
        frames[bad].tool[0].status |= core::sample_status::kRefused;
    }
    const auto trials = assemble(frames);
    QCOMPARE(trials.size(), std::size_t{1});
    QCOMPARE(trials[0].tools[0].t_s,
             (std::vector<double>{0.001, 0.002, 0.003, 0.005, 0.006, 0.007})); // since the first good one
    for (const core::Vec3& p : trials[0].tools[0].p_WT_m)
        QVERIFY(p.x() < 0.1);
    QVERIFY(trials[0].marked);
    QCOMPARE(trials[0].p_WMark_m.x(), 0.008); // where the last good packet left the tool
}

void TestTraceAssembler::timedOutTrial() {
    auto frames = someFrames(10);
    frames[1].header.events = bits::kTrialStarted;
    frames[8].header.events = bits::kTimedOut;
    const auto trials = assemble(frames);
    QCOMPARE(trials.size(), std::size_t{1});
    QVERIFY(!trials[0].marked && trials[0].timedOut);
    QCOMPARE(trials[0].p_WMark_m.x(), 0.008);
}

void TestTraceAssembler::unmarkedTrialStays() {
    auto frames = someFrames(10);
    frames[4].header.events = bits::kTrialStarted;
    const auto trials = assemble(frames);
    QCOMPARE(trials.size(), std::size_t{1});
    QVERIFY(!trials[0].marked && !trials[0].timedOut && !trials[0].markInContact);
    QCOMPARE(trials[0].tools[0].t_s.size(), std::size_t{6}); // up to the last frame
    QVERIFY(assemble(someFrames(10)).empty());               // never started: no trial
    auto onlyMark = someFrames(10);
    onlyMark[5].header.events = bits::kMarked; // of a trial that is not there
    QVERIFY(assemble(onlyMark).empty());
}

void TestTraceAssembler::markOfATraceEndIsNone() {
    auto frames = someFrames(10);
    frames[1].header.events = bits::kTrialStarted;
    frames[8].header.events = bits::kMarked;
    frames[8].header.commands[0] = {core::CommandKind::mark, 0}; // by key: as good as the device's button
    QVERIFY(assemble(frames)[0].marked);
    frames[8].header.commands[0].argument = session::kMarkOfTraceEnd;
    const auto trials = assemble(frames);
    QVERIFY(!trials[0].marked && !trials[0].timedOut);
    QCOMPARE(trials[0].p_WMark_m.x(), 0.008); // where it is scored all the same
}

void TestTraceAssembler::chunksMakeNoDifference() {
    auto frames = someFrames(50);
    frames[5].header.events = bits::kTrialStarted;
    frames[33].header.events = bits::kMarked;
    const auto whole = assemble(frames);
    const MillimetreCounts positions;
    for (const std::size_t chunk : {std::size_t{1}, std::size_t{7}, std::size_t{34}}) {
        session::TraceAssembler assembler(positions, 1);
        for (std::size_t at = 0; at < frames.size(); at += chunk)
            assembler.add(std::span(frames).subspan(at, std::min(chunk, frames.size() - at)));
        const auto pieces = assembler.takeTrials();
        QCOMPARE(pieces.size(), whole.size());
        QCOMPARE(pieces[0].tools[0].t_s, whole[0].tools[0].t_s);
        QVERIFY(pieces[0].tools[0].p_WT_m == whole[0].tools[0].p_WT_m);
        QCOMPARE(pieces[0].marked, whole[0].marked);
    }
}

void TestTraceAssembler::pausedSamplesAreFlagged() {
    auto frames = someFrames(6);
    frames[0].header.events = bits::kTrialStarted;
    frames[2].header.paused = frames[3].header.paused = 1;
    const auto trials = assemble(frames);
    QCOMPARE(trials[0].tools[0].paused, (std::vector<std::uint8_t>{0, 0, 1, 1, 0, 0}));
}

void TestTraceAssembler::packetReadTwiceIsOneSample() {
    auto frames = someFrames(8);
    frames[0].header.events = bits::kTrialStarted;
    frames[3].tool[0] = frames[2].tool[0];                                   // nothing new came
    frames[5].tool[0].deviceTime_us = frames[4].tool[0].deviceTime_us - 500; // an older packet, late
    const auto trials = assemble(frames);
    QCOMPARE(trials[0].tools[0].t_s, (std::vector<double>{0.0, 0.001, 0.002, 0.004, 0.006, 0.007}));
    QCOMPARE(trials[0].tools[0].paused.size(), std::size_t{6});
    QCOMPARE(trials[0].tools[0].tissue_N.size(), std::size_t{6});
    auto start = someFrames(4);
    start[1].tool[0] = start[0].tool[0];
    start[1].header.events = bits::kTrialStarted; // its packet was read before the trial began
    QCOMPARE(assemble(start)[0].tools[0].t_s, (std::vector<double>{0.002, 0.003}));
}

void TestTraceAssembler::markOnARepeatedPacketCounts() {
    auto frames = someFrames(5);
    frames[0].header.events = bits::kTrialStarted;
    frames[4].tool[0] = frames[3].tool[0];
    frames[4].tool[0].tissue[2] = 0.5; // the scene answers every tick
    frames[4].header.events = bits::kMarked;
    const auto trials = assemble(frames);
    QVERIFY(trials[0].marked && trials[0].markInContact);
    QCOMPARE(trials[0].p_WMark_m.x(), 0.003);
    QCOMPARE(trials[0].tools[0].t_s.size(), std::size_t{4});
}

void TestTraceAssembler::storedGrids() {
    class Fine final : public recording::IPositionOf {
    public:
        core::Vec3 p_WT_m(int, const core::ToolFrame&) const noexcept override {
            return {1.23456789049e-3, 0.0, 0.0};
        }
    };
    auto frames = someFrames(1);
    frames[0].header.events = bits::kTrialStarted;
    frames[0].tool[0].tissue[0] = 0.12349;
    frames[0].tool[0].commanded[1] = -0.0006;
    const Fine positions;
    session::TraceAssembler assembler(positions, 1);
    assembler.add(frames);
    const auto trials = assembler.takeTrials();
    QCOMPARE(trials[0].tools[0].p_WT_m[0].x(), 0.001234568); // 1 nm
    QCOMPARE(trials[0].tools[0].tissue_N[0].x(), 0.123);     // 1 mN
    QCOMPARE(trials[0].tools[0].commanded_N[0].y(), -0.001);
}

void TestTraceAssembler::contactAtTheMark() {
    for (const auto& [force_N, touching] : {std::pair{0.0, false}, {0.02, false}, {0.021, true}}) {
        auto frames = someFrames(3);
        frames[0].header.events = bits::kTrialStarted;
        frames[2].header.events = bits::kMarked;
        frames[2].tool[0].tissue[2] = force_N;
        QCOMPARE(assemble(frames)[0].markInContact, touching);
    }
}

void TestTraceAssembler::measuredForceOnlyWhereMeasured() {
    auto frames = someFrames(4);
    frames[0].header.events = bits::kTrialStarted;
    for (auto& frame : frames)
        frame.tool[0].measured[0] = 0.7; // of no meaning without the status bit
    QVERIFY(assemble(frames)[0].tools[0].measured_N.empty());
    frames[2].tool[0].status = core::sample_status::kMeasuredForce;
    const auto measured = assemble(frames)[0].tools[0].measured_N;
    QCOMPARE(measured.size(), std::size_t{4});
    QCOMPARE(measured[1].x(), 0.0);
    QCOMPARE(measured[2].x(), 0.7);
    QCOMPARE(measured[3].x(), 0.0);
}

void TestTraceAssembler::everyToolHasItsTrace() {
    auto frames = someFrames(5, 0, 2);
    frames[0].header.events = bits::kTrialStarted;
    frames[2].tool[1] = frames[1].tool[1]; // the second tool alone repeats
    const auto trials = assemble(frames, 2);
    QCOMPARE(trials[0].tools.size(), std::size_t{2});
    QCOMPARE(trials[0].tools[0].t_s.size(), std::size_t{5});
    QCOMPARE(trials[0].tools[1].t_s.size(), std::size_t{4});
    QCOMPARE(trials[0].tools[1].p_WT_m[0].x(), 0.1);
}

void TestTraceAssembler::completedTrial() {
    auto frames = someFrames(20);
    frames[3].header.events = bits::kTrialStarted;
    frames[9].header.events = bits::kCompleted | bits::kStageChanged;
    const auto trials = assemble(frames);
    QCOMPARE(trials.size(), std::size_t{1});
    QVERIFY(trials[0].completed && !trials[0].marked && !trials[0].timedOut);
    QCOMPARE(trials[0].tools[0].t_s.size(), std::size_t{7}); // both ends included, nothing after
    QCOMPARE(trials[0].p_WMark_m.x(), 0.009);
    frames[9].header.events =
        bits::kStageChanged | simulation::procedure_bits::kLandmarkSeen; // these end nothing
    QVERIFY(!assemble(frames)[0].completed);
    QCOMPARE(assemble(frames)[0].tools[0].t_s.size(), std::size_t{17});
}

void TestTraceAssembler::orientationAndTorqueOfToolsThatTurn() {
    auto frames = someFrames(4, 0, 2);
    frames[0].header.events = bits::kTrialStarted;
    for (auto& frame : frames) {
        frame.tool[0].counts[3] = 90;
        frame.tool[0].tissue = {0, 0, 0, 0.0123456, -0.0000051, 0.15};
        frame.tool[1].tissue = frame.tool[0].tissue;
    }
    const Turning turning;
    const auto trials = assemble(frames, 2, &turning);
    const scoring::ToolTrace& tool = trials[0].tools[0];
    QCOMPARE(tool.q_WT.size(), std::size_t{4});
    QVERIFY(std::abs(tool.q_WT[2].x() - std::sqrt(0.5)) < 1e-15);
    QCOMPARE(tool.tissueTorque_Nm.size(), std::size_t{4});
    QCOMPARE(tool.tissueTorque_Nm[1].x(), 0.01235); // 0.01 mN·m
    QCOMPARE(tool.tissueTorque_Nm[1].y(), -0.00001);
    QCOMPARE(tool.tissueTorque_Nm[1].z(), 0.15);
    QVERIFY(trials[0].tools[1].q_WT.empty() && trials[0].tools[1].tissueTorque_Nm.empty());
    const auto cartesian = assemble(frames, 2);
    QVERIFY(cartesian[0].tools[0].q_WT.empty() && cartesian[0].tools[0].tissueTorque_Nm.empty());
}

void TestTraceAssembler::orientationAndTorqueFollowTheSamples() {
    auto frames = someFrames(10);
    frames[0].header.events = bits::kTrialStarted;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].tool[0].counts[3] = static_cast<std::int32_t>(i);
        frames[i].tool[0].tissue[3] = 1e-5 * static_cast<double>(i);
    }
    frames[4].tool[0].status |= core::sample_status::kRefused;
    frames[6].tool[0] = frames[5].tool[0];
    const Turning turning;
    const auto trials = assemble(frames, 1, &turning);
    const scoring::ToolTrace& tool = trials[0].tools[0];
    QCOMPARE(tool.t_s.size(), std::size_t{8});
    QCOMPARE(tool.q_WT.size(), std::size_t{8});
    const std::vector<int> expected{0, 1, 2, 3, 5, 7, 8, 9};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        QCOMPARE(tool.tissueTorque_Nm[i].x(), expected[i] / 1e5);
        QVERIFY(std::abs(tool.q_WT[i].x() - std::sin(0.017453292519943295 * expected[i] / 2.0)) < 1e-15);
    }
}

QTEST_APPLESS_MAIN(TestTraceAssembler)
#include "test_trace_assembler.moc"
