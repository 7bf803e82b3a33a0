// SPDX-License-Identifier: GPL-3.0-or-later
// What P1's forces cost: UrethraForces beside the plain reference (every section, every spring) on the same
// insertion.
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "core/clock.h"
#include "core/fp_environment.h"
#include "core/random.h"
#include "core/units.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"
#include "realtime/tick_guard.h"
#include "support/urethra_reference_forces.h"

#include <cmath>
#include <cstdio>

using namespace chiron;
using namespace chiron::bench;
using core::Vec3;

namespace {

constexpr int kRepeats = 9;
constexpr int kTicks = 20'000;       // 20 s at 1 kHz: in, a look round, out
constexpr double kGoal = 0.83 / 0.2; // the goal was set as 0.2 µs where plain code took 0.83 µs

/// An insertion as a hand makes it: in for 12 s, 3 s in the bladder, out; off the centre by waves of
/// `offset_m` with tremor on top, tilted up to 9°.
std::vector<simulation::EndoscopeMotion> insertion(const simulation::UrethraCentreline& line,
                                                   double offset_m) {
    core::Random random(7);
    std::vector<simulation::EndoscopeMotion> path;
    const double deepest = line.length_m() + 0.020;
    for (int i = 0; i < kTicks; ++i) {
        const double t = 0.001 * i;
        const double way = t < 12.0 ? t / 12.0 : t < 15.0 ? 1.0 : (20.0 - t) / 5.0;
        const simulation::CentrelinePoint at = line.at(-0.012 + (deepest + 0.012) * way);
        const auto wave = [&](double hertz, double phase) {
            return std::sin(2.0 * core::kPi * hertz * t + phase);
        };
        simulation::EndoscopeMotion m;
        const double ex = offset_m * (0.7 * wave(0.31, 0.2) + 0.3 * wave(1.1, 1.0)) + 5e-5 * wave(9.0, 0.0);
        const double en = offset_m * (0.7 * wave(0.23, 1.9) + 0.3 * wave(0.9, 0.4)) + 5e-5 * wave(9.0, 1.6);
        m.p_A = at.p_A + ex * Vec3::UnitX() + en * at.n_A;
        const double pitch = at.psi_rad + 0.15 * wave(0.17, 0.7), yaw = 0.1 * wave(0.27, 2.0);
        m.axis_A = Vec3(std::sin(yaw), std::cos(yaw) * std::sin(pitch), std::cos(yaw) * std::cos(pitch));
        m.v_A = 0.012 * at.t_A + Vec3(random.uniform(-0.004, 0.004), random.uniform(-0.004, 0.004), 0.0);
        m.w_A = 0.8 * wave(0.5, 0.0) * m.axis_A;
        path.push_back(m);
    }
    return path;
}

/// CPU time of one call over the path, ns.
template <class Respond>
double nsEach(const std::vector<simulation::EndoscopeMotion>& path, Respond&& respond) {
    double sum = 0.0;
    const double spent_s = cpuSeconds([&] {
        for (const simulation::EndoscopeMotion& m : path)
            sum += respond(m);
    });
    volatile double sink = sum;
    (void)sink;
    return 1e9 * spent_s / static_cast<double>(path.size());
}

void compare(std::vector<BenchRow>& rows, const char* name, const simulation::UrethraForceSettings& settings,
             double offset_m) {
    const simulation::UrethraForces forces({}, {}, settings);
    const testing::UrethraReferenceForces plain({}, {}, settings);
    const auto path = insertion(forces.centreline(), offset_m);
    std::vector<double> ours, peers, single;
    tests::resetForbiddenCounts();
    for (int r = 0; r < kRepeats; ++r) {
        peers.push_back(nsEach(path, [&](const auto& m) { return plain.respond(m).force.y(); }));
        ours.push_back(nsEach(path, [&](const auto& m) {
            const tests::TickGuard guard;
            return forces.respond(m).wrench_A.force.y();
        }));
    }
    double worst = 0.0;
    for (const simulation::EndoscopeMotion& m : path) {
        const std::int64_t start_ns = core::monotonicNow_ns();
        const simulation::UrethraResponse mine = forces.respond(m);
        single.push_back(static_cast<double>(core::monotonicNow_ns() - start_ns));
        const testing::ReferenceResponse theirs = plain.respond(m);
        worst = std::max({worst, (mine.wrench_A.force - theirs.force).norm(),
                          (mine.wrench_A.torque - theirs.torque).norm()});
    }
    BenchRow row{.work = name, .peer = "plain code"};
    row.peerMedian = median(peers);
    row.oursMedian = median(ours);
    row.p99 = percentile(single, 0.99);
    row.p999 = percentile(single, 0.999);
    row.allocations = tests::forbiddenCounts().of(tests::Forbidden::allocate);
    row.agreement = text("%.1g N, N·m", worst);
    row.goal = "ratio ≥ 4.15, 0 allocations";
    row.reached = verdict(*row.ratio() >= kGoal && *row.allocations == 0);
    rows.push_back(row);
}

} // namespace

int main() {
    core::setModelFloatingPointEnvironment();
    printHeading("Forces of urethra insertion, a call");
    simulation::UrethraForceSettings drawn;
    drawn.sections = simulation::ForceSections::p1Basic;
    std::vector<BenchRow> rows;
    compare(rows, "112 fine sections, offsets to 0.8 mm (no spring slack)", {}, 0.0008);
    compare(rows, "112 fine sections, offsets to 3 mm (springs slack)", {}, 0.003);
    compare(rows, "26 drawn sections, offsets to 0.8 mm", drawn, 0.0008);
    compare(rows, "26 drawn sections, offsets to 3 mm", drawn, 0.003);
    printTable(rows);
    std::printf("%d repeats of %d poses in turn; p99 and p99.9 of single calls include one clock read.\n",
                kRepeats, kTicks);
    return 0;
}
