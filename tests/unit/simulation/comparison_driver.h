// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/comparison/comparison_scene.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

namespace chiron::simulation::testing {

using core::Vec3;

/// Three objects of one attribute: candidate 0 has {v, 1.5 v, 2 v}, candidate 1 {v, 1.1 v, 1.2 v};
/// arrangement 0 lies from left to right, 1 from right to left.
inline ComparisonParameters compared(ComparedAttribute attribute) {
    ComparisonParameters p;
    p.attribute = attribute;
    p.object.stiffness_N_per_m = 400.0;
    p.object.damping_Ns_per_m = 1.0;
    double value = 150.0;
    switch (attribute) {
    case ComparedAttribute::stiffness:
        p.object.viscosity_Ns_per_m = 0.5;
        break;
    case ComparedAttribute::mass:
        value = 0.05;
        break;
    case ComparedAttribute::deformation:
        value = 0.08;
        p.object.recoveryShare = 1.0;
        break;
    case ComparedAttribute::roughness:
        value = 100e-6;
        p.object.roughnessWavelength_m = 0.003;
        break;
    case ComparedAttribute::friction:
        value = 0.25;
        break;
    case ComparedAttribute::viscosity:
        value = 4.0;
        break;
    }
    p.values = {{value, 1.5 * value, 2.0 * value}, {value, 1.1 * value, 1.2 * value}};
    p.arrangements = {{0, 1, 2}, {2, 1, 0}};
    p.exploreLimit_s = 20.0;
    p.answerLimit_s = 1.0;
    p.betweenTrials_s = 0.020;
    p.cues = {"object"};
    return p;
}

/// Without damping, recovery and friction: what is left is conservative.
inline ComparisonParameters lossless(ComparedAttribute attribute) {
    ComparisonParameters p = compared(attribute);
    p.object.damping_Ns_per_m = p.object.viscosity_Ns_per_m = 0.0;
    p.exploreLimit_s = 0.0;
    return p;
}

inline constexpr ComparedAttribute kComparedAttributes[] = {
    ComparedAttribute::stiffness, ComparedAttribute::mass,     ComparedAttribute::deformation,
    ComparedAttribute::roughness, ComparedAttribute::friction, ComparedAttribute::viscosity};

/// Steps the scene as the loop does, with one smoothly moving tool whose velocity is the difference of its
/// places.
struct ComparisonDriver {
    explicit ComparisonDriver(const ComparisonParameters& given, std::uint64_t seed = 42)
        : parameters(given), scene(given, seed) {
        in.tools.count = 1;
        in.started = in.forceReady = true;
        tool().p_WT = Vec3(0.0, 0.0, 0.080);
    }
    core::ToolState& tool() { return in.tools.tools[0]; }
    Vec3 force() const { return out.tissue.tools[0].force; }
    double quantity(std::size_t which) const { return out.quantities[which]; }

    const SceneOutput& tick() {
        if (ticksDone > 0)
            tool().v_WT = (tool().p_WT - last) / 0.001;
        const Vec3 forceBefore = force();
        const double storedBefore_J = out.storedEnergy_J;
        scene.respond(source.next(0), in, out);
        if (ticksDone > 0) { // trapezoid: of a force that is a gradient nothing is left
            work_J -= 0.5 * (forceBefore + force()).dot(tool().p_WT - last);
            largestStep_N = std::max(largestStep_N, (force() - forceBefore).norm());
            largestMade_J = std::max(largestMade_J,
                                     out.storedEnergy_J - storedBefore_J + force().dot(tool().p_WT - last));
        }
        last = tool().p_WT;
        ++ticksDone;
        events |= out.events;
        if (witness)
            witness(out);
        in.present = in.answer = in.mark = false;
        return out;
    }
    void ticks(int n) {
        for (int i = 0; i < n; ++i)
            tick();
    }
    void present(int candidate, int arrangement) {
        in.present = true;
        in.presented = core::encode({candidate, arrangement});
        tick();
    }
    /// Into the first running tick of a trial.
    void startRunning(int candidate = 0, int arrangement = 0) {
        present(candidate, arrangement);
        for (int i = 0; i < 100 && out.phase != core::TrialPhase::running; ++i)
            tick();
    }
    void answer(std::uint16_t word) {
        in.answer = true;
        in.answered = word;
        tick();
    }
    /// There in `seconds`, minimum jerk.
    void moveTo(const Vec3& goal, double seconds) {
        const Vec3 from = tool().p_WT;
        const int n = std::max(1, static_cast<int>(std::lround(slowness * seconds * 1000.0)));
        for (int i = 1; i <= n; ++i) {
            const double s = static_cast<double>(i) / n;
            tool().p_WT = from + s * s * s * (10.0 - 15.0 * s + 6.0 * s * s) * (goal - from);
            tick();
        }
    }
    Vec3 at(int place, double z_m, double y_m = 0.0) const { return {placeX_m(parameters, place), y_m, z_m}; }
    double hook_m() const { return parameters.hookHeight_m; }
    /// Touches a place as its attribute asks for and leaves it.
    void explore(int place) {
        if (isHooked(parameters.attribute)) {
            moveTo(at(place, hook_m() + 0.04), 0.3);
            const bool tube = parameters.attribute == ComparedAttribute::stiffness;
            moveTo(at(place, hook_m() - (tube ? 0.003 : 0.0)), 0.4);
            moveTo(at(place, hook_m() + 0.012), 0.3);
            moveTo(at(place, hook_m() - 0.016 * (tube ? 1.0 : 0.25)), 0.3);
            moveTo(at(place, hook_m() + (tube ? -0.016 : 0.02), tube ? 0.02 : 0.0), 0.3);
            moveTo(at(place, hook_m() + 0.04, tube ? 0.02 : 0.0), 0.3);
            return;
        }
        moveTo(at(place, 0.02, -0.006), 0.2);
        moveTo(at(place, -0.003, -0.006), 0.2);
        moveTo(at(place, -0.003, 0.006), 0.2);
        moveTo(at(place, -0.004, -0.006), 0.2);
        moveTo(at(place, 0.02), 0.2);
    }

    ComparisonParameters parameters;
    realtime::TickSource source;
    ComparisonScene scene;
    SceneInput in;
    SceneOutput out;
    Vec3 last = Vec3::Zero();
    std::uint64_t ticksDone = 0;
    std::uint32_t events = 0;
    std::function<void(const SceneOutput&)> witness; ///< sees every answer
    double slowness = 1.0;                           ///< every way takes so many times as long
    double work_J = 0.0;                             ///< put in by the hand
    double largestStep_N = 0.0;
    double largestMade_J = 0.0; ///< in a tick: stored and given beyond what was put in
};

} // namespace chiron::simulation::testing
