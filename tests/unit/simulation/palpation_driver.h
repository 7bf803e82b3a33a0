// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/simulation/palpation_scene.h"

#include <cmath>
#include <vector>

namespace chiron::simulation::testing {

using core::Vec3;

/// A flat pad with one lump a trial.
inline PalpationParameters flatPad() {
    PalpationParameters p;
    p.tissue.stiffness_N_per_m = 650.0;
    p.trials = 2;
    p.trialLimit_s = 5.0;
    p.betweenTrials_s = 0.020;
    p.cues = {"object", "tool", "bars", "coverage"};
    return p;
}

/// One report, as the recorded quantities tell it.
struct ToldReport {
    ReportField field;
    int finding;
    unsigned value;
    Vec3 p_W;
};

/// Steps a scene as the loop does, with fingers that are where they are put; keeps what the quantities told.
struct PalpationDriver {
    explicit PalpationDriver(const PalpationParameters& given, std::uint64_t seed = 42)
        : parameters(given), scene(given, seed) {
        in.tools.count = given.tools();
        for (int i = 0; i < in.tools.count; ++i)
            at(i, 0.010 * i, 0.0, 0.020);
    }
    void at(int finger, double x_m, double y_m, double z_m) {
        in.tools.tools[static_cast<std::size_t>(finger)].p_WT = Vec3(x_m, y_m, z_m);
    }
    const SceneOutput& tick() {
        scene.respond(source.next(0), in, out);
        in.mark = false;
        in.reports = 0;
        events |= out.events;
        if (out.quantities[palpation_quantity::kReportCount] > count)
            keep();
        count = out.quantities[palpation_quantity::kReportCount];
        return out;
    }
    void ticks(int n) {
        for (int i = 0; i < n; ++i)
            tick();
    }
    /// Into the first running tick of the first trial.
    void startRunning() {
        in.started = in.forceReady = true;
        ticks(2);
    }
    void command(ReportField field, unsigned value) {
        in.report[static_cast<std::size_t>(in.reports++)] = reportWord(field, value);
    }
    /// Until all that was reported has been taken.
    void settle() { ticks(static_cast<int>(ReportQueue::kRoom * PalpationScene::kReportTicks)); }
    void press(int finger, std::uint32_t buttons) {
        in.tools.tools[static_cast<std::size_t>(finger)].buttons = buttons;
        tick();
        in.tools.tools[static_cast<std::size_t>(finger)].buttons = 0;
        tick();
    }
    const PalpationTrial& trial() const { return scene.trials()[out.trial]; }
    Vec3 force(std::size_t finger = 0) const { return out.tissue.tools[finger].force; }

    PalpationParameters parameters;
    realtime::TickSource source;
    PalpationScene scene;
    SceneInput in;
    SceneOutput out;
    std::uint32_t events = 0;
    double count = 0.0;
    std::vector<ToldReport> told;

private:
    void keep() {
        namespace q = palpation_quantity;
        const auto& v = out.quantities;
        told.push_back({static_cast<ReportField>(std::lround(v[q::kReportField])),
                        static_cast<int>(std::lround(v[q::kReportFinding])),
                        static_cast<unsigned>(std::lround(v[q::kReportValue])),
                        {v[q::kFindingPlace], v[q::kFindingPlace + 1], v[q::kFindingPlace + 2]}});
    }
};

} // namespace chiron::simulation::testing
