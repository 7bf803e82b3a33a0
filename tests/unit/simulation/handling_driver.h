// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/object_handling/simulation/object_handling_scene.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace chiron::simulation::testing {

using core::Vec3;

inline ObjectAttributes plainOvary() {
    ObjectAttributes a;
    a.id = "ovary";
    a.stiffness_N_per_m = 300.0;
    a.stiffening_per_m = 60.0;
    a.mass_kg = 0.010;
    a.friction = 0.25;
    return a;
}

inline ObjectAttributes plainBed() {
    ObjectAttributes a;
    a.id = "plane";
    a.stiffness_N_per_m = 800.0;
    a.friction = 0.3;
    a.damping_Ns_per_m = 2.0;
    return a;
}

inline ObjectHandlingParameters oneOvary() {
    ObjectHandlingParameters p;
    p.object = plainOvary();
    p.bed = plainBed();
    p.trials = 2;
    p.hold_s = 0.2;
    p.trialLimit_s = 60.0;
    p.betweenTrials_s = 0.020;
    p.cues = {"object", "tool", "bars"};
    return p;
}

/// The same on a soft organ, wide and flat.
inline ObjectHandlingParameters onOrgan(ObjectHandlingParameters p) {
    p.organBed = true;
    p.bed.stiffness_N_per_m = 300.0;
    p.bedMesh.shape = MeshSource::Shape::ellipsoid;
    p.bedMesh.halfAxisX_m = p.bedMesh.halfAxisY_m = 0.090;
    p.bedMesh.halfAxisZ_m = 0.014;
    p.bedMesh.edge_m = 0.006;
    p.placesRadius_m = 0.028;
    return p;
}

/// Steps a scene as the loop does, with one grasper that moves smoothly: its velocity is the difference of
/// its places.
struct HandlingDriver {
    explicit HandlingDriver(const ObjectHandlingParameters& given, std::uint64_t seed = 42)
        : parameters(given), scene(given, seed) {
        in.tools.count = 1;
        tool().p_WT = Vec3(0.0, 0.0, 0.080);
        open();
    }
    core::ToolState& tool() { return in.tools.tools[0]; }
    double jawFor(double opening_m) const { return JawGeometry{parameters.jawLength_m}.angle_rad(opening_m); }
    void open() {
        tool().jaw_rad = jawFor(2.0 * parameters.radius_m + parameters.releaseClearance_m + 0.004);
    }

    const SceneOutput& tick() {
        if (hasBefore)
            tool().v_WT = (tool().p_WT - before) / 0.001;
        before = tool().p_WT;
        hasBefore = true;
        const Vec3 forceBefore = out.tissue.tools[0].force;
        const Vec3 place = tool().p_WT;
        scene.respond(source.next(0), in, out);
        if (ticksDone > 0) {
            work_J -= forceBefore.dot(place - lastPlace); // what the hand has put in
            largestStep_N = std::max(largestStep_N, (out.tissue.tools[0].force - forceBefore).norm());
        }
        lastPlace = place;
        ++ticksDone;
        events |= out.events;
        if (observe)
            observe(*this);
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
    /// There in `seconds`, smoothly: 10 s³ − 15 s⁴ + 6 s⁵ (minimum jerk).
    void moveTo(const Vec3& goal, double seconds) {
        const Vec3 from = tool().p_WT;
        const int n = std::max(1, static_cast<int>(std::lround(seconds * 1000.0)));
        for (int i = 1; i <= n; ++i) {
            const double s = static_cast<double>(i) / n;
            tool().p_WT = from + s * s * s * (10.0 - 15.0 * s + 6.0 * s * s) * (goal - from);
            tick();
        }
    }
    void moveBy(const Vec3& way, double seconds) { moveTo(tool().p_WT + way, seconds); }
    /// The jaws that far open in `seconds`, smoothly.
    void jawTo(double opening_m, double seconds) {
        const double from = tool().jaw_rad;
        const double goal = jawFor(opening_m);
        const int n = std::max(1, static_cast<int>(std::lround(seconds * 1000.0)));
        for (int i = 1; i <= n; ++i) {
            const double s = static_cast<double>(i) / n;
            tool().jaw_rad = from + s * s * (3.0 - 2.0 * s) * (goal - from);
            tick();
        }
    }
    /// Opening at which each jaw presses `depth_m` deep.
    double openingFor(double depth_m) const { return 2.0 * (parameters.radius_m - depth_m); }
    const LooseBody& body(std::size_t i = 0) const { return scene.world().body(i); }
    const ObjectHandlingTrial& trial() const { return scene.trials()[out.trial]; }
    Vec3 force() const { return out.tissue.tools[0].force; }
    double q(std::size_t i) const { return out.quantities[i]; }

    /// Over the object, open, down to its middle and closed on it.
    void graspObject(std::size_t i = 0, double depth_m = 0.002) {
        open();
        const Vec3 middle = body(i).p_W;
        moveTo(middle + Vec3(0.0, 0.0, 0.040), 0.4);
        moveTo(middle, 0.4);
        jawTo(openingFor(depth_m), 0.3);
    }
    Vec3 overTarget(double height_m) const {
        return Vec3(trial().target_m.x(), trial().target_m.y(), height_m);
    }

    ObjectHandlingParameters parameters;
    realtime::TickSource source;
    ObjectHandlingScene scene;
    SceneInput in;
    SceneOutput out;
    std::uint32_t events = 0;
    double work_J = 0.0;
    double largestStep_N = 0.0;
    int ticksDone = 0;
    std::function<void(HandlingDriver&)> observe;
    Vec3 before = Vec3::Zero();
    Vec3 lastPlace = Vec3::Zero();
    bool hasBefore = false;
};

} // namespace chiron::simulation::testing
