// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/level_sweep.h"

#include "core/contact_bits.h"
#include "core/presentation_word.h"
#include "cues/laparoscopy_cues.h"
#include "session/exercise_kind.h"
#include "session/session_setup.h"
#include "session/station.h"
#include "session/training_run.h"
#include "simulation/scene.h"
#include "sweep/guarded_contact.h"
#include "sweep/hand_path.h"
#include "sweep/level_numbers.h"
#include "sweep/sweep_facts.h"
#include "sweep/true_contact.h"

#include <cstdio>
#include <vector>

namespace chiron::tests {

namespace {

using core::Vec3;

constexpr double kSteepest = 1.5; ///< of a smoothstep, in its middle
/// What is left of a dent that recovers is no energy that a contact begins or ends with.
constexpr double kNothing_J = 1e-9;
/// A loose object that goes less than this in a tick lies still (45 g at 1 mm/s: 0.02 µJ).
constexpr double kStill_m = 1e-6;

/// One tool's tick before.
struct Before {
    bool known = false;
    Vec3 p = Vec3::Zero(), force = Vec3::Zero(), v = Vec3::Zero(), torque = Vec3::Zero(), w = Vec3::Zero();
    core::Quat q = core::Quat::Identity();
    double damping_Ns_per_m = 0.0; ///< that the laws used
};

/// The turn from one orientation to the next, as a vector; exact to the third order of the angle.
Vec3 turnOf(const core::Quat& from, const core::Quat& to) {
    const core::Quat turn = to * from.conjugate();
    return (turn.w() < 0.0 ? -2.0 : 2.0) * turn.vec();
}

class Sweep {
public:
    Sweep(const catalogue::ExerciseLevel& level, const SweepSettings& settings)
        : m_settings(settings), m_numbers(numbersOf(level)), m_facts(SweepFacts::of(level.exercise)) {
        auto kind = session::exerciseKind(level.exercise);
        if (!kind)
            qFatal("%s", kind.error().message.c_str());
        m_kind = *kind;
        m_setup.level = level;
        auto station =
            session::scriptedStation(*m_kind, level, m_kind->operatorNames().front(), settings.seed);
        if (!station)
            qFatal("%s", station.error().message.c_str());
        for (std::size_t i = 0; i < station->tools.size(); ++i) {
            m_setup.devices.push_back(station->tools[i].device->descriptor());
            m_setup.mappings.push_back(station->tools[i].mapping);
            m_reach.emplace_back(m_setup.devices.back(), m_setup.mappings.back());
        }
        m_result.level = level.exercise + "/" + std::to_string(level.number) + " " + level.id;
        m_result.limit_N = m_kind->forceLimit_N(level);
        m_result.limit_Nm = m_kind->caps(level).torque_Nm;
        m_result.givesWay = m_numbers.givesWay;
        m_result.yieldStated = m_numbers.yield_N > 0.0;
        if (m_result.yieldStated)
            m_result.yieldForce_N = m_numbers.yield_N;
        m_result.yieldTorque_Nm = m_numbers.yield_Nm;
        m_setup.safety = session::headlessSafety(level);
        m_result.cap_N = std::min(m_setup.safety.siteForce_N, m_setup.safety.exerciseForce_N);
        m_result.measured = m_facts != nullptr;
    }

    SweepResult run() {
        for (int path = m_settings.firstPath; path < m_settings.firstPath + m_settings.paths; ++path) {
            if (path % m_settings.pathsPerScene == 0 || m_out.phase == core::TrialPhase::finished)
                appear(path);
            follow(static_cast<std::uint64_t>(path));
        }
        leaveGuard();
        return m_result;
    }

private:
    void appear(int path) {
        m_wayAt = 0;
        m_setup.seed = m_settings.seed + static_cast<std::uint64_t>(path);
        m_in = {};
        m_in.started = m_in.forceReady = true;
        m_in.force = core::ForceState::on;
        m_in.tools.count = static_cast<int>(m_reach.size());
        m_ticks = {};
        m_out = {};
        m_hands.clear();
        for (std::size_t i = 0; i < m_reach.size(); ++i)
            m_hands.emplace_back(m_reach[i],
                                 core::Random::stream(m_setup.seed, "sweep hand " + std::to_string(i)));
        beginInTheAir();
        for (std::size_t i = 0; i < m_hands.size(); ++i)
            m_clear[i] = m_hands[i].now().p_WT;
        if (!m_settings.onlyInTheAir && (path / m_settings.pathsPerScene) % 2 == 1)
            beginAnywhere();
        m_true.reset(); // before its scene
        m_scene = m_kind->makeScene(m_setup);
        m_result.conservative = m_scene->conservative();
        if (m_settings.guarded)
            enterGuard();
        else if (m_facts != nullptr)
            m_true = m_facts->trueContact(m_setup, *m_scene);
        m_out = {};
        m_met.fill(std::nullopt);
        m_presented = false;
        m_escaped = m_escapedBefore = 0.0;
        m_guess = core::Random::stream(m_setup.seed, "sweep guess");
        m_before.assign(m_reach.size(), {});
        m_bitsBefore = {};
        m_stiffnessBefore = m_storedBefore_J = 0.0;
        m_open = false;
    }

    void enterGuard() {
        leaveGuard();
        std::vector<double> budgets_Ns_per_m;
        for (const devices::DeviceDescriptor& device : m_setup.devices)
            budgets_Ns_per_m.push_back(device.maximumDamping_Ns_per_m);
        m_guard = std::make_unique<GuardedContact>(budgets_Ns_per_m, m_setup.safety);
        for (std::size_t i = 0; i < m_setup.devices.size(); ++i)
            m_in.dampingBudget_Ns_per_m[i] = m_guard->budget_Ns_per_m(i);
    }
    void leaveGuard() {
        if (m_guard)
            m_result.withheld_J += m_guard->out().energyWithheld_J;
        m_guard.reset();
    }

    /// Within tissue, too, and under the table: each tool from where its mechanism reaches, next to what lies
    /// about the origin of W if it reaches that.
    void beginAnywhere() {
        constexpr int kDraws = 200;
        for (HandPath& hand : m_hands)
            for (int draw = 0; draw < kDraws; ++draw) {
                hand.drawStart();
                const Vec3& p = hand.now().p_WT;
                if (p.head<2>().norm() < 0.050 && p.z() > -0.030 && p.z() < 0.030)
                    break;
            }
    }

    /// Neither within tissue nor under the table (z = 0): each tool from where a fresh scene answers it with
    /// nothing for half a second, after which what is simulated more slowly has answered too.
    void beginInTheAir() {
        constexpr int kDraws = 1000;
        for (int draw = 0; draw < kDraws; ++draw) {
            const auto scene = m_kind->makeScene(m_setup);
            realtime::TickSource ticks;
            simulation::SceneOutput out;
            for (std::size_t i = 0; i < m_hands.size(); ++i)
                m_in.tools.tools[i] = m_hands[i].now();
            bool clear = true;
            for (int tick = 0; tick < 500 && clear; ++tick) {
                scene->respond(ticks.next(0), m_in, out);
                for (std::size_t i = 0; i < m_hands.size(); ++i) {
                    if (out.tissue.tools[i].force == Vec3::Zero() && out.contact[i] == 0 &&
                        m_in.tools.tools[i].p_WT.z() > 0.0)
                        continue;
                    m_hands[i].drawStart();
                    clear = false;
                }
            }
            if (clear)
                return;
        }
        qFatal("%s: no place in the air", m_result.level.c_str());
    }

    /// A place that is worth going to: out again where tissue gave way, else a loose object, or where a tube
    /// may be held.
    std::optional<Vec3> lure(std::size_t tool) {
        if ((m_out.contact[tool] & core::contact_bits::kThrough) != 0)
            return m_clear[tool];
        if (const std::vector<Vec3>& way = m_numbers.way_W; !way.empty()) { // a stretch at a time
            if ((m_in.tools.tools[tool].p_WT - way[m_wayAt]).norm() < 0.001)
                m_wayAt = (m_wayAt + 1) % way.size();
            return way[m_wayAt];
        }
        const core::LaparoscopyCues& cues = m_out.cues.exercise.of<core::LaparoscopyCues>();
        if (cues.bodies > 0)
            return Vec3(cues.body[0].p_W[0], cues.body[0].p_W[1], cues.body[0].p_W[2]);
        if (cues.fold && tool + 1 == m_hands.size()) // the last tool holds back what lies over the tube
            return Vec3(cues.p_WFoldEdge[0], cues.p_WFoldEdge[1], cues.p_WFoldEdge[2]);
        if (cues.grips > 0) {
            const auto grips = static_cast<std::size_t>(
                cues.grips); // the end for the first tool, the other end or a place between for the others
            const auto& p = cues.p_WGrip[tool % 2 == 0 ? grips - 1 : (cues.gripAnchored[0] ? grips / 2 : 0)];
            return Vec3(p[0], p[1], p[2]);
        }
        if (m_met[tool])
            return m_met[tool];
        if (const std::vector<Vec3>& places = m_numbers.places_W; !places.empty())
            return places[m_guess.below(places.size())];
        return Vec3(m_guess.uniform(-0.05, 0.05), m_guess.uniform(-0.05, 0.05),
                    m_guess.uniform(-0.02, 0.04)); // scenes lie about the origin of W
    }

    void follow(std::uint64_t path) {
        const int ticks = static_cast<int>(m_settings.path_s / core::kTickSeconds);
        for (int tick = 0; tick < ticks; ++tick) {
            for (std::size_t i = 0; i < m_hands.size(); ++i)
                m_in.tools.tools[i] = m_hands[i].step(lure(i), m_out.tissue.tools[i].force != Vec3::Zero());
            if (m_numbers.candidates > 0)
                present();
            m_scene->respond(m_ticks.next(0), m_in, m_out);
            look(path, static_cast<std::uint64_t>(tick));
            if (m_settings.witness)
                m_settings.witness(path, static_cast<std::uint64_t>(tick), m_out);
        }
    }

    /// What a study's runner does: some pair as soon as there is none.
    void present() {
        m_in.present = m_out.phase == core::TrialPhase::idle || m_out.phase == core::TrialPhase::between;
        if (m_in.present && !m_presented)
            m_in.presented = core::encode({static_cast<int>(m_guess.below(m_numbers.candidates)),
                                           static_cast<int>(m_guess.below(m_numbers.arrangements))});
        m_presented = m_in.present;
    }

    static void keep(Worst& worst, double value, std::uint64_t path, std::uint64_t tick, std::size_t tool,
                     const Vec3& p) {
        if (value > worst.value)
            worst = {value, path, tick, tool, p};
    }

    /// Of a tube, what the other hands do to it while this one holds still: what stretches it is the way
    /// between them.
    struct Ends {
        double way_m = 0.0, speed_m_per_s = 0.0, sped_m_per_s = 0.0;
    };

    void look(std::uint64_t path, std::uint64_t tick) {
        ++m_result.ticks;
        const bool told = m_out.storedEnergy_J != 0.0 || m_out.contactStiffness_N_per_m != 0.0;
        const bool appeared =
            (m_out.events & core::event_bits::kSceneChanged) != 0 || m_out.phase != m_phaseBefore;
        bodiesMoved();
        const std::vector<Ends> otherEnds = endsMoved();
        if (m_true)
            m_true->follow(m_in, m_out);
        if (m_guard)
            guard(appeared, path, tick);
        bool touching = false;
        double work = 0.0;
        for (std::size_t i = 0; i < m_before.size(); ++i) {
            const core::ToolState& tool = m_in.tools.tools[i];
            const core::Wrench& wrench = m_out.tissue.tools[i];
            const double size = wrench.force.norm();
            m_result.finite = m_result.finite && wrench.force.allFinite() && wrench.torque.allFinite();
            touching = touching || size > 0.0;
            keep(m_result.force, size, path, tick, i, tool.p_WT);
            keep(m_result.torque, wrench.torque.norm(), path, tick, i, tool.p_WT);
            if (!told)
                keep(m_result.inAirAsTold, size, path, tick, i, tool.p_WT);
            const std::uint8_t bits = m_out.contact[i];
            if (size > 0.0 && !appeared && m_true && (bits & core::contact_bits::kThrough) == 0 &&
                m_true->clearance_m(i, m_in, m_out) > m_true->tolerance_m())
                keep(m_result.inAir, size, path, tick, i, tool.p_WT);
            m_result.beyondChecked += (bits & core::contact_bits::kBeyondChecked) != 0 ? 1 : 0;
            m_result.yields += (bits & core::contact_bits::kYielded) != 0 ? 1 : 0;
            if (size == 0.0 && bits == 0)
                m_clear[i] = tool.p_WT;
            if (size > 0.0 && bits == 0)
                m_met[i] = tool.p_WT;
            const Before& before = m_before[i];
            if (before.known && !appeared) {
                compare(before, tool, i, otherEnds[i], path, tick);
                if (!m_true || !m_true->slides(i))
                    work += 0.5 * (wrench.force + before.force).dot(tool.p_WT - before.p) +
                            0.5 * (wrench.torque + before.torque).dot(turnOf(before.q, tool.q_WT));
            }
            m_before[i] = {true,          tool.p_WT, wrench.force, tool.v_WT,
                           wrench.torque, tool.w_WT, tool.q_WT,    m_out.damping_Ns_per_m[i]};
            m_bitsBefore[i] = bits;
        }
        m_result.touching += touching ? 1 : 0;
        count(touching, appeared, work, path, tick);
        m_stiffnessBefore = m_out.contactStiffness_N_per_m;
        m_storedBefore_J = m_out.storedEnergy_J;
        m_phaseBefore = m_out.phase;
    }

    /// By how much force and torque changed more than they may since the tick before.
    void compare(const Before& before, const core::ToolState& tool, std::size_t i, const Ends& others,
                 std::uint64_t path, std::uint64_t tick) {
        const core::Wrench& wrench = m_out.tissue.tools[i];
        const double allowed = allowed_N(before, tool, i, others);
        const double change = (wrench.force - before.force).norm() - allowed;
        const double turned = turnChange(before, tool, wrench.torque, m_out.damping_Ns_per_m[i], allowed);
        if (((m_out.contact[i] | m_bitsBefore[i]) & core::contact_bits::kThrough) != 0) {
            keep(m_result.fall, change - kSteepest * m_result.yieldForce_N / m_numbers.fall_ms, path, tick, i,
                 tool.p_WT);
            keep(m_result.torqueFall, turned - kSteepest * m_result.yieldTorque_Nm / m_numbers.fall_ms, path,
                 tick, i, tool.p_WT);
        } else {
            keep(m_result.change, change, path, tick, i, tool.p_WT);
            keep(m_result.torqueChange, turned, path, tick, i, tool.p_WT);
        }
    }

    /// How much a force may change in one tick, but for 0.1 N (testing.md, The sweep, argues each term):
    ///   (1 + μ) ((k + F ∇∇h) w + b (Δv + v c w) + Δb v + √(2 k₁ U) dt/τ) + σ₀ w + B
    /// w: the way, between tool and object, which of a tube is the way between the hands that hold it; k and
    /// b as the scene reports them, the larger of both ticks; v, Δv: speed and its change; B: what is meant
    /// to break.
    double allowed_N(const Before& before, const core::ToolState& tool, std::size_t i,
                     const Ends& others) const {
        const double way =
            (tool.p_WT - before.p).norm() + std::max(m_escaped, m_escapedBefore) + others.way_m;
        const double speed = std::max(tool.v_WT.norm(), before.v.norm()) + others.speed_m_per_s +
                             std::max(m_escaped, m_escapedBefore) / core::kTickSeconds;
        const double turn = before.q.angularDistance(tool.q_WT);
        const double sped =
            (tool.v_WT - before.v).norm() + others.sped_m_per_s + m_escapeSped_m_per_s +
            (m_numbers.shaft_m > 0.0 ? m_numbers.shaft_m * (tool.w_WT - before.w).norm() + turn * speed
                                     : 0.0);
        const double damping = m_out.damping_Ns_per_m[i];
        const double stiffness =
            std::max(m_out.contactStiffness_N_per_m, m_stiffnessBefore) +
            m_numbers.rough_per_m * std::max(m_out.tissue.tools[i].force.norm(), before.force.norm());
        const double damps = std::max(damping, before.damping_Ns_per_m);
        const double relaxes_N = std::sqrt(2.0 * m_numbers.relaxing_N_per_m * m_storedBefore_J) *
                                 core::kTickSeconds / m_numbers.relaxes_s;
        return (1.0 + m_numbers.friction) *
                   (stiffness * way + damps * (sped + speed * m_numbers.turn_per_m * way) +
                    std::abs(damping - before.damping_Ns_per_m) * speed + relaxes_N) +
               m_numbers.bristle_N_per_m * way + m_numbers.breaks_N_per_ms;
    }

    void guard(bool appeared, std::uint64_t path, std::uint64_t tick) {
        m_guard->step(m_in.tools, m_out, appeared);
        const haptics::SafetyOutput& safe = m_guard->out();
        m_result.damped += (safe.guards & core::guard_bits::kPassivity) != 0 ? 1 : 0;
        for (std::size_t i = 0; i < m_before.size(); ++i)
            keep(m_result.commanded, safe.tools[i].wrench_W.force.norm(), path, tick, i,
                 m_in.tools.tools[i].p_WT);
        if (!m_guard->counts())
            return;
        keep(m_result.returned, m_guard->returned_J(), path, tick, 0, m_in.tools.tools[0].p_WT);
        keep(m_result.brought, m_guard->grown_J(), path, tick, 0, m_in.tools.tools[0].p_WT);
        keep(m_result.overReturned, m_guard->over_J(m_out), path, tick, 0, m_in.tools.tools[0].p_WT);
    }

    std::vector<Ends> endsMoved() const {
        std::vector<Ends> ends(m_before.size());
        if (m_out.cues.exercise.of<core::LaparoscopyCues>().grips == 0)
            return ends;
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t k = 0; k < ends.size(); ++k)
                if (k != i && m_before[k].known) {
                    const core::ToolState& tool = m_in.tools.tools[k];
                    ends[i].way_m += (tool.p_WT - m_before[k].p).norm();
                    ends[i].speed_m_per_s += std::max(tool.v_WT.norm(), m_before[k].v.norm());
                    ends[i].sped_m_per_s += (tool.v_WT - m_before[k].v).norm();
                }
        return ends;
    }

    /// By how much the torque changed more than it may; `force_N`: what the force may change by.
    double turnChange(const Before& before, const core::ToolState& tool, const Vec3& torque,
                      double damping_Ns_per_m, double force_N) const {
        constexpr double kLeaning = 4.0 / 3.0; // 1/cos² of 30°, as far as tilts are checked
        const double turn = before.q.angularDistance(tool.q_WT), way = (tool.p_WT - before.p).norm();
        const double r2 = m_numbers.shaft_m * m_numbers.shaft_m;
        const double spin =
            r2 * (std::max(damping_Ns_per_m, before.damping_Ns_per_m) * (tool.w_WT - before.w).norm() +
                  std::abs(damping_Ns_per_m - before.damping_Ns_per_m) *
                      std::max(tool.w_WT.norm(), before.w.norm()));
        return (torque - before.torque).norm() -
               kLeaning * (m_numbers.turn_Nm_per_rad * turn + m_numbers.turn_Nm_per_m * way) -
               m_numbers.shaft_m * force_N - (1.0 + m_numbers.friction) * spin;
    }

    /// How far any loose object went since the tick before: the way is that between tool and object. A body's
    /// place is told after it has moved, a held one's at once, so that both this way and the last one count.
    void bodiesMoved() {
        m_escapedBefore = m_escaped;
        m_escaped = m_escapeSped_m_per_s = 0.0;
        const core::LaparoscopyCues& cues = m_out.cues.exercise.of<core::LaparoscopyCues>();
        for (std::size_t i = 0; i < static_cast<std::size_t>(cues.bodies); ++i) {
            const Vec3 p(cues.body[i].p_W[0], cues.body[i].p_W[1], cues.body[i].p_W[2]);
            const Vec3 way = p - m_bodies[i];
            m_escaped = std::max(m_escaped, way.norm());
            m_escapeSped_m_per_s =
                std::max({m_escapeSped_m_per_s, (way - m_bodyWays[i][0]).norm() / core::kTickSeconds,
                          (m_bodyWays[i][0] - m_bodyWays[i][1]).norm() / core::kTickSeconds});
            m_bodies[i] = p;
            m_bodyWays[i] = {way, m_bodyWays[i][0]};
        }
    }

    /// Books over one contact of all tools, from nothing stored and everything still to the same again:
    /// closed, they say what the law made.
    void count(bool touching, bool appeared, double work, std::uint64_t path, std::uint64_t tick) {
        const bool idle = !touching && m_out.storedEnergy_J <= kNothing_J && m_escaped < kStill_m;
        if (m_open && !appeared)
            m_work_J += work;
        if (m_open && idle && !appeared && m_touched) {
            keep(m_result.made, m_work_J, path, tick, 0, m_in.tools.tools[0].p_WT);
            ++m_result.closed;
        }
        m_touched = (m_touched || touching) && !idle && !appeared;
        if (idle || appeared)
            m_work_J = 0.0;
        m_open = (m_open || idle) && !appeared;
    }

    SweepSettings m_settings;
    LevelNumbers m_numbers;
    const SweepFacts* m_facts; ///< null: nobody wrote them
    const session::ExerciseKind* m_kind = nullptr;
    session::SessionSetup m_setup;
    std::vector<ToolReach> m_reach;
    std::vector<HandPath> m_hands; ///< after what they reach
    std::unique_ptr<simulation::IScene> m_scene;
    std::unique_ptr<TrueContact> m_true; ///< of that scene
    std::unique_ptr<GuardedContact> m_guard;
    simulation::SceneInput m_in;
    simulation::SceneOutput m_out;
    realtime::TickSource m_ticks;
    std::vector<Before> m_before;
    std::array<std::uint8_t, core::kMaxTools> m_bitsBefore{};
    std::array<Vec3, core::kMaxTools> m_clear{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                              Vec3::Zero()}; ///< where each touched nothing last
    std::array<Vec3, core::LaparoscopyCues::kMaxBodies> m_bodies{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                                                 Vec3::Zero()};
    std::array<std::array<Vec3, 2>, core::LaparoscopyCues::kMaxBodies> m_bodyWays{
        {{Vec3::Zero(), Vec3::Zero()},
         {Vec3::Zero(), Vec3::Zero()},
         {Vec3::Zero(), Vec3::Zero()},
         {Vec3::Zero(), Vec3::Zero()}}}; ///< in the last two ticks
    double m_escaped = 0.0, m_escapedBefore = 0.0, m_escapeSped_m_per_s = 0.0;
    bool m_presented = false;
    std::array<std::optional<Vec3>, core::kMaxTools> m_met; ///< where each last touched tissue that was whole
    core::Random m_guess = core::Random::stream(0, "sweep guess");
    std::size_t m_wayAt = 0;
    double m_stiffnessBefore = 0.0, m_storedBefore_J = 0.0;
    core::TrialPhase m_phaseBefore = core::TrialPhase::idle;
    bool m_open = false;    ///< the books began with nothing stored
    bool m_touched = false; ///< since then
    double m_work_J = 0.0;
    SweepResult m_result;
};

std::string at(const Worst& worst) {
    char text[120];
    std::snprintf(text, sizeof text, " [path %llu tick %llu tool %zu (%.1f %.1f %.1f) mm]",
                  static_cast<unsigned long long>(worst.path), static_cast<unsigned long long>(worst.tick),
                  worst.tool, 1e3 * worst.p_W.x(), 1e3 * worst.p_W.y(), 1e3 * worst.p_W.z());
    return text;
}

double shown(const Worst& worst, double unit = 1.0) {
    return std::isfinite(worst.value) ? worst.value * unit : 0.0;
}

} // namespace

SweepResult sweepLevel(const catalogue::ExerciseLevel& level, const SweepSettings& settings) {
    return Sweep(level, settings).run();
}

std::string SweepResult::heading() {
    return "level                                     F max N  yields at N   over the bound N  over fall N   "
           "in air N  as told N  law  made uJ  closed   T max mNm  yields at  over bound  over fall   yields "
           " "
           "beyond %  contact %";
}

std::string SweepResult::line() const {
    char text[480];
    const double all = static_cast<double>(std::max<std::uint64_t>(1, ticks));
    std::snprintf(
        text, sizeof text,
        "%-40s %8.3f  %11.2f  %17.3f  %10.3f  %9.4f  %9.4f  %3s  %8.3f  %6llu  %10.1f  %9.1f  %10.3f "
        " %9.3f  %7llu  %8.2f  %9.1f",
        level.c_str(), shown(force), yieldForce_N, shown(change), shown(fall), shown(inAir),
        shown(inAirAsTold), conservative ? "-dU" : "no", shown(made, 1e6),
        static_cast<unsigned long long>(closed), shown(torque, 1e3), 1e3 * yieldTorque_Nm,
        shown(torqueChange, 1e3), shown(torqueFall, 1e3), static_cast<unsigned long long>(yields),
        100.0 * static_cast<double>(beyondChecked) / all, 100.0 * static_cast<double>(touching) / all);
    return std::string(text) + "\n    F" + at(force) + "  change" + at(change) + "  fall" + at(fall) +
           "  air" + at(inAir) + "  made" + at(made) + "  T" + at(torque) + "  T change" + at(torqueChange);
}

std::string SweepResult::guardedHeading() {
    return "level                                    law  made uJ (law)  returned mJ  in a tick mJ  over "
           "what "
           "is allowed mJ  commanded N  cap N  acted %  withheld mJ";
}

std::string SweepResult::guardedLine() const {
    char text[320];
    const double all = static_cast<double>(std::max<std::uint64_t>(1, ticks));
    std::snprintf(text, sizeof text,
                  "%-40s %3s  %13.3f  %11.4f  %12.4f  %23.4f  %11.3f  %5.2f  %7.2f  %11.3f", level.c_str(),
                  conservative ? "-dU" : "no", shown(made, 1e6), shown(returned, 1e3), shown(brought, 1e3),
                  shown(overReturned, 1e3), shown(commanded), cap_N,
                  100.0 * static_cast<double>(damped) / all, 1e3 * withheld_J);
    return std::string(text) + "\n    returned" + at(returned) + "  in a tick" + at(brought) + "  over" +
           at(overReturned);
}

} // namespace chiron::tests
