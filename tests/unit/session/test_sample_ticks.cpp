// SPDX-License-Identifier: GPL-3.0-or-later
// How many running ticks had a sample as their newest: what the scene counted, whatever the device's clock
// says.
#include "frames.h"
#include "session/trace_assembler.h"

#include <QtTest>

using namespace chiron;
namespace bits = core::event_bits;

class TestSampleTicks : public QObject {
    Q_OBJECT
private slots:
    void samplesKnowTheirTicks();
};

// A device of 250 Hz whose clock counts 0.9 of a millisecond a tick; a pause in between, a refused packet, a
// repeated one at the start.
void TestSampleTicks::samplesKnowTheirTicks() {
    auto frames = tests::someFrames(24);
    for (std::size_t i = 0; i < frames.size(); ++i)
        frames[i].tool[0].deviceTime_us = 5'000'000 + i / 4 * 3600;
    frames[2].header.events = bits::kTrialStarted; // its packet came at tick 0
    frames[9].header.paused = frames[10].header.paused = 1;
    for (const std::size_t i : {std::size_t{16}, std::size_t{17}})
        frames[i].tool[0].status |= core::sample_status::kRefused;
    frames[21].header.events = bits::kCompleted;
    const tests::MillimetreCounts positions;
    session::TraceAssembler assembler(positions, 1);
    assembler.add(frames);
    const auto trials = assembler.takeTrials();
    const scoring::ToolTrace& tool = trials.at(0).tools.at(0);
    QCOMPARE(tool.t_s, (std::vector<double>{0.0036, 0.0072, 0.0108, 0.0144, 0.018}));
    // 2–7 (from before its first sample on), 8 and 11, 12–17, 18 and 19, 20 and 21
    QCOMPARE(tool.heldTicks, (std::vector<std::uint32_t>{6, 2, 6, 2, 2}));
}

QTEST_APPLESS_MAIN(TestSampleTicks)
#include "test_sample_ticks.moc"
