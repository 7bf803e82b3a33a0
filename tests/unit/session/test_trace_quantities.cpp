// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's quantities and a failed trial, from frames to what metrics see.
#include "frames.h"
#include "session/trace_assembler.h"

#include <QtTest>

using namespace chiron;
using tests::MillimetreCounts;
using tests::someFrames;
namespace bits = core::event_bits;

namespace {
std::vector<scoring::TrialTrace> assemble(const std::vector<core::HapticFrame>& frames, int tools = 1) {
    const MillimetreCounts positions;
    session::TraceAssembler assembler(positions, tools);
    assembler.add(frames);
    return assembler.takeTrials();
}
} // namespace

class TestTraceQuantities : public QObject {
    Q_OBJECT
private slots:
    void quantitiesFollowTheSamplesOfToolZero();
    void failedTrial();
};

/// One value a sample of the first tool, as the frame had it; a packet read twice or refused adds none, nor
/// do ticks between trials.
void TestTraceQuantities::quantitiesFollowTheSamplesOfToolZero() {
    const recording::ToolChannels tool{{{"x", "m", 1e-3}}, 0.0, 1000};
    const std::vector<recording::ToolChannels> tools{tool, tool};
    const auto table =
        recording::ChannelTable::forTools(tools, {{{"tension_N", "N", 1e-3}, {"grip_0", "1", 1.0}}, true});
    QVERIFY(table);
    auto frames = someFrames(12, 0, 2);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].header.quantities[0] = 0.125 * static_cast<double>(i);
        frames[i].header.quantities[1] = static_cast<double>(i % 2);
        frames[i].header.energySupplied_J = 0.5 * static_cast<double>(i);
    }
    frames[2].header.events = bits::kTrialStarted;
    frames[9].header.events = bits::kCompleted;
    frames[5].tool[0].deviceTime_us = frames[4].tool[0].deviceTime_us; // read twice
    frames[6].tool[0].status |= core::sample_status::kRefused;
    frames[7].tool[1].status |= core::sample_status::kRefused; // the other tool's
    const MillimetreCounts positions;
    session::TraceAssembler assembler(positions, 2, nullptr, session::RecordedQuantities(*table));
    assembler.add(frames);
    const auto trials = assembler.takeTrials();
    QCOMPARE(trials.size(), std::size_t{1});
    const auto& quantities = trials[0].quantities;
    QCOMPARE(quantities.size(), std::size_t{4});
    QCOMPARE(quantities[0].id, std::string("tension_N"));
    QCOMPARE(quantities[0].values, (std::vector<double>{0.25, 0.375, 0.5, 0.875, 1.0, 1.125}));
    QCOMPARE(quantities[1].values, (std::vector<double>{0.0, 1.0, 0.0, 1.0, 0.0, 1.0}));
    QCOMPARE(quantities[2].id, std::string("energy_supplied_J"));
    QCOMPARE(quantities[2].values.back(), 4.5);
    QCOMPARE(quantities[3].id, std::string("energy_stored_J"));
    for (const auto& quantity : quantities)
        QCOMPARE(quantity.values.size(), trials[0].tools[0].t_s.size());
    QVERIFY(assemble(frames, 2)[0].quantities.empty()); // a recording without them
}

void TestTraceQuantities::failedTrial() {
    auto frames = someFrames(10);
    frames[2].header.events = bits::kTrialStarted;
    frames[6].header.events = bits::kFailed | bits::kDamaged;
    const auto trials = assemble(frames);
    QVERIFY(trials[0].failed && !trials[0].marked && !trials[0].completed && !trials[0].timedOut);
    QCOMPARE(trials[0].tools[0].t_s.size(), std::size_t{5}); // its end belongs to it
}

QTEST_APPLESS_MAIN(TestTraceQuantities)
#include "test_trace_quantities.moc"
