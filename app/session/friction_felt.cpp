// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/friction_felt.h"

#include "core/units.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"
#include "session/station.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace chiron::session {

namespace {

using core::Vec3;

constexpr std::array<double, 6> kSpeeds_m_per_s{0.001, 0.010, 0.020, 0.050, 0.100, 0.150};
/// From this speed on, the compensation must reduce the friction felt by at least kTaken times the friction
/// felt at the lowest speed.
constexpr double kMoving_m_per_s = 0.045;
constexpr double kTaken = 0.6;
constexpr double kStill_N = 0.001; ///< a larger change is a push on a still hand
constexpr double kArming_s = 3.0, kHeld_s = 2.0, kTurn_s = 0.5;
constexpr double kSettling = 0.4; ///< fraction of a half that is left out at its start
constexpr double kBraking = 0.1;  ///< fraction that is left out at its end

/// Half the length of a stroke: the distance covered in one second, limited to 4 to 45 mm.
double halfOf(double speed_m_per_s) {
    return std::clamp(speed_m_per_s, 0.004, 0.045);
}

struct Stroke {
    Vec3 direction = Vec3::UnitX();
    double speed_m_per_s = 0.0;
    double begin_s = 0.0; ///< start; then to one end, to the other end and back to the middle: 4 halves and
                          ///< two turns
    double half_s() const { return halfOf(speed_m_per_s) / speed_m_per_s; }
    double end_s() const { return begin_s + 4.0 * half_s() + 2.0 * kTurn_s; }
};

/// The hand's measurements during one stroke.
struct Noted {
    double there_N = 0.0, back_N = 0.0;
    int there = 0, back = 0;
    double felt_N() const { return there > 0 && back > 0 ? 0.5 * (there_N / there + back_N / back) : 0.0; }
};

struct Notes {
    std::vector<Stroke> strokes;
    std::vector<Noted> noted;
    Vec3 held_N = Vec3::Zero(); ///< force when the hand began to hold still
    double change_N = 0.0;
    double work_J = 0.0;
    double end_s = 0.0;
};

Notes plan() {
    Notes notes;
    double at_s = kArming_s + kHeld_s;
    for (const Vec3& direction : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitZ())})
        for (const double speed : kSpeeds_m_per_s) {
            notes.strokes.push_back({direction, speed, at_s});
            at_s = notes.strokes.back().end_s() + kTurn_s;
        }
    notes.noted.resize(notes.strokes.size());
    notes.end_s = at_s;
    return notes;
}

/// Moves as planned and records the felt forces.
class FeelingHand final : public mechanisms::HandStrategy {
public:
    FeelingHand(const Vec3& centre_D, Notes& notes) : m_centre_D(centre_D), m_notes(notes) {}
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = m_centre_D;
        const double t = seen.time_s;
        if (t >= kArming_s)
            m_notes.work_J -= seen.f_T_D.dot(seen.v_DT) * core::kTickSeconds;
        if (t >= kArming_s && t < kArming_s + kHeld_s) {
            if (t < kArming_s + core::kTickSeconds)
                m_notes.held_N = seen.f_T_D;
            m_notes.change_N = std::max(m_notes.change_N, (seen.f_T_D - m_notes.held_N).norm());
        }
        while (m_next < m_notes.strokes.size() && t >= m_notes.strokes[m_next].end_s())
            ++m_next;
        if (m_next < m_notes.strokes.size() && t >= m_notes.strokes[m_next].begin_s)
            stroke(m_notes.strokes[m_next], m_notes.noted[m_next], t, seen, wanted);
        return wanted;
    }

private:
    /// Moves out by one half, back by two, and out by one half. Forces are averaged over the middle part of
    /// each movement.
    void stroke(const Stroke& s, Noted& noted, double t, const mechanisms::HandPerception& seen,
                mechanisms::HandIntention& wanted) noexcept {
        const double half = s.half_s(), in = t - s.begin_s;
        const double turned = half + kTurn_s, back = turned + 2.0 * half + kTurn_s;
        double x = 0.0, v = 0.0; // position in halves; velocity in halves per second
        if (in < half)
            x = in / half, v = 1.0 / half;
        else if (in < turned)
            x = 1.0;
        else if (in < turned + 2.0 * half)
            x = 1.0 - (in - turned) / half, v = -1.0 / half;
        else if (in < back)
            x = -1.0;
        else
            x = -1.0 + (in - back) / half, v = 1.0 / half;
        const double way_m = halfOf(s.speed_m_per_s);
        wanted.p_DDesired = m_centre_D + x * way_m * s.direction;
        wanted.v_DDesired = v * way_m * s.direction;
        const double along_N = seen.f_T_D.dot(s.direction);
        const double progress = (in - turned) / (2.0 * half); // progress of the movement back, 0..1
        if (progress > kSettling && progress < 1.0 - kBraking)
            noted.back_N += along_N, ++noted.back;
        const double out = in < half ? in / half : (in - back) / half;
        if ((in < half || in >= back) && out > kSettling && out < 1.0 - kBraking)
            noted.there_N -= along_N, ++noted.there;
    }
    Vec3 m_centre_D;
    Notes& m_notes;
    std::size_t m_next = 0;
};

/// A scene with nothing to touch.
class FreeAir final : public simulation::IScene {
public:
    void respond(const realtime::HapticTick&, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override {
        out = simulation::SceneOutput{};
        out.tissue.count = in.tools.count;
        out.phase = core::TrialPhase::running;
    }
};

class NoFrames final : public core::IFrameSink {
public:
    bool tryPush(const core::HapticFrame&) noexcept override { return true; }
};

core::Result<Notes> feel(const mechanisms::GimbalPlantParameters& plant, double compensation) {
    Notes notes = plan();
    SimulatedHand feeling;
    feeling.strategy = std::make_unique<FeelingHand>(devices::kHeldFrom_D, notes);
    feeling.hand.tremorRms_m = 0.0;
    feeling.hand.reactionDelay_s = 0.0;
    feeling.frictionCompensation = compensation;
    feeling.plant = plant;
    auto station = simulatedStation(devices::kGimbalHprd, std::move(feeling));
    CHIRON_TRY(station);
    const StationTool& tool = station->tools.front();
    CHIRON_TRY(tool.device->open());
    NoFrames frames;
    haptics::LiveInputs inputs;
    haptics::SafetySupervisor supervisor;
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene = std::make_unique<FreeAir>();
    scenes.offer(scene);
    const std::array<haptics::LoopTool, 1> tools{haptics::LoopTool{*tool.device, tool.mapping}};
    auto loop = haptics::HapticLoop::create({tools, inputs, supervisor, {}, scenes, frames});
    CHIRON_TRY(loop);
    inputs.post({core::CommandKind::start});
    realtime::TickSource ticks;
    for (std::int64_t n = 0; n < static_cast<std::int64_t>(1000.0 * notes.end_s); ++n)
        (void)(*loop)->tick(ticks.next(n * 1'000'000));
    tool.device->close();
    return notes;
}

} // namespace

bool FrictionFelt::holds() const {
    double breaking_N = 0.0; // in the direction of the row
    for (const FrictionFeltRow& row : rows) {
        if (row.speed_m_per_s <= kSpeeds_m_per_s.front())
            breaking_N = row.before_N;
        if (!(row.after_N > 0.0))
            return false;
        if (row.speed_m_per_s >= kMoving_m_per_s && !(row.after_N < row.before_N - kTaken * breaking_N))
            return false;
    }
    return workAfter_J > 0.0 && heldAfter_N <= heldBefore_N + kStill_N;
}

core::Result<FrictionFelt> feelFriction(const mechanisms::GimbalPlantParameters& plant, double compensation) {
    const auto before = feel(plant, 0.0);
    CHIRON_TRY(before);
    const auto after = feel(plant, compensation);
    CHIRON_TRY(after);
    FrictionFelt felt;
    felt.compensation = compensation;
    for (std::size_t i = 0; i < before->strokes.size(); ++i) {
        const Stroke& stroke = before->strokes[i];
        felt.rows.push_back({stroke.direction.x() > 0.5 ? "sideways" : "along", stroke.speed_m_per_s,
                             before->noted[i].felt_N(), after->noted[i].felt_N()});
    }
    felt.heldBefore_N = before->change_N;
    felt.heldAfter_N = after->change_N;
    felt.workBefore_J = before->work_J;
    felt.workAfter_J = after->work_J;
    return felt;
}

} // namespace chiron::session
