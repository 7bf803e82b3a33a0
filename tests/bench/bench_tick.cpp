// SPDX-License-Identifier: GPL-3.0-or-later
// What a whole tick costs: device packet, scene, supervisor, crash ring and display state, for every level of
// the sphere-apex exercise and of palpation; and the force law alone. Back to back, so caches are warm:
// bench_loop_lateness shows the tick at 1 kHz.
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "bench/tick_session.h"
#include "core/clock.h"
#include "core/fp_environment.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_scene.h"
#include "session/tool_positions.h"

#include <cstdio>

using namespace chiron;
using namespace chiron::bench;

namespace {
constexpr int kRepeats = 7;
constexpr int kLevels = 4;     ///< of sphere_apex
constexpr int kPalpations = 5; ///< levels of palpation, one or two tools
constexpr std::size_t kTicks = 30'000;
constexpr std::size_t kWarmUp_ticks = 2'000;
constexpr double kMedianGoal_ns = 1000.0;
constexpr double kTailGoal_ns = 5000.0;
constexpr double kLawGoal_ns = 10.0;

/// Repeats of one kind of pass.
struct Passes {
    std::vector<double> medians;
    std::vector<double> all;
    std::uint64_t allocations = 0;
    std::uint64_t otherForbidden = 0;
    std::uint64_t dropped = 0;

    void add(const TickTimes& times) {
        const std::vector<double> warm(times.tick_ns.begin() + kWarmUp_ticks, times.tick_ns.end());
        medians.push_back(median(warm));
        all.insert(all.end(), warm.begin(), warm.end());
        allocations += times.allocations;
        otherForbidden += times.otherForbidden;
        dropped += times.dropped;
    }
};

BenchRow rowOf(const std::string& work, const Passes& passes, const std::string& agreement, bool judged) {
    BenchRow row{.work = work};
    row.oursMedian = median(passes.medians);
    row.p99 = percentile(passes.all, 0.99);
    row.p999 = percentile(passes.all, 0.999);
    row.allocations = passes.allocations;
    row.agreement = agreement;
    const std::uint64_t wrong = passes.otherForbidden + passes.dropped;
    if (wrong > 0)
        row.agreement +=
            text("; %llu forbidden calls or dropped frames", static_cast<unsigned long long>(wrong));
    if (judged) {
        row.goal = "median ≤ 1000, p99.9 ≤ 5000, 0 allocations";
        row.reached = verdict(*row.oursMedian <= kMedianGoal_ns && *row.p999 <= kTailGoal_ns &&
                              passes.allocations + wrong == 0);
    }
    return row;
}

template <class Value> Value orExit(core::Result<Value> value) {
    if (!value) {
        std::fprintf(stderr, "%s\n", value.error().message.c_str());
        std::exit(1);
    }
    return std::move(*value);
}

/// CPU time of one call of the law, over the recorded places of the tool inside the object.
void addLaw(std::vector<BenchRow>& rows, const RecordedSession& recorded, const char* name, bool judged) {
    const auto positions = orExit(session::ToolPositions::create(recorded.setup));
    const auto& parameters = recorded.setup.level.parameters.as<simulation::SphereApexParameters>();
    const simulation::HemisphereContact law(simulation::sphereApexContact(
        parameters, simulation::planSphereApexTrials(parameters, recorded.setup.seed)[0]));
    std::vector<core::Vec3> places;
    for (const core::HapticFrame& frame : recorded.frames)
        if (const core::Vec3 p = positions->p_WT_m(0, frame.tool[0]);
            law.respond(p, core::Vec3::Zero()).inContact)
            places.push_back(p);
    if (places.empty())
        return;
    const core::Vec3 velocity(0.02, -0.01, 0.005);
    std::vector<double> ours;
    volatile double sink = 0.0;
    constexpr int kRounds = 20;
    for (int r = 0; r < kRepeats; ++r) {
        simulation::BristleFriction bristle;
        double sum = 0.0;
        const double spent_s = cpuSeconds([&] {
            for (int round = 0; round < kRounds; ++round)
                for (const core::Vec3& p : places)
                    sum += law.respond(p, velocity, bristle).force.z();
        });
        ours.push_back(1e9 * spent_s / (kRounds * static_cast<double>(places.size())));
        sink = sum;
    }
    (void)sink;
    BenchRow row{.work = name, .peer = "CHAI3D sphere: 220 published, not measured here"};
    row.oursMedian = median(ours);
    row.agreement = text("%zu recorded places", places.size());
    if (judged) {
        row.goal = "≤ 10";
        row.reached = verdict(*row.oursMedian <= kLawGoal_ns);
    }
    rows.push_back(row);
}

double clockCost_ns() {
    std::vector<double> cost;
    for (int i = 0; i < 10'000; ++i) {
        const std::int64_t start_ns = core::monotonicNow_ns();
        cost.push_back(static_cast<double>(core::monotonicNow_ns() - start_ns));
    }
    return median(cost);
}
} // namespace

int main() {
    core::setModelFloatingPointEnvironment();
    printHeading("Whole tick, sphere-apex exercise and palpation, into the crash ring");
    std::vector<BenchRow> rows;
    std::vector<RecordedSession> sessions;
    for (int level = 1; level <= kLevels; ++level)
        sessions.push_back(
            orExit(recordSession("sphere_apex", level, 40 + static_cast<std::uint64_t>(level), kTicks)));
    for (int level = 1; level <= kPalpations; ++level)
        sessions.push_back(
            orExit(recordSession("palpation", level, 40 + static_cast<std::uint64_t>(level), kTicks)));
    std::vector<Passes> alone(sessions.size()), plant(sessions.size());
    for (int r = 0; r < kRepeats; ++r) // levels and ways alternate
        for (std::size_t i = 0; i < sessions.size(); ++i) {
            alone[i].add(orExit(timeWithRecordedDevice(sessions[i])));
            plant[i].add(orExit(timeWithPlant(sessions[i])));
        }
    for (std::size_t i = 0; i < sessions.size(); ++i) {
        const RecordedSession& s = sessions[i];
        const std::size_t same = orExit(sameFrames(s));
        const char* id = s.setup.level.id.c_str();
        rows.push_back(rowOf(text("tick, level %d %s, %zu tool(s), recorded device", s.setup.level.number, id,
                                  s.setup.devices.size()),
                             alone[i], text("%zu of %zu frames same bits", same, s.frames.size()), true));
        rows.push_back(rowOf("the same with simulated plant and hand", plant[i], "–", false));
    }
    addLaw(rows, sessions[1], "hemisphere law alone, level 2", true);
    addLaw(rows, sessions[2], "hemisphere law, varied stiffness, friction (level 3)", false);
    printTable(rows);
    std::printf("%d repeats of %zu ticks; each time includes one clock read of %.0f ns.\n", kRepeats, kTicks,
                clockCost_ns());
    return 0;
}
