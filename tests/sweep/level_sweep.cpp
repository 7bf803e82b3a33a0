// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/level_sweep.h"

#include "core/contact_bits.h"
#include "cues/laparoscopy_cues.h"
#include "session/exercise_kind.h"
#include "session/session_setup.h"
#include "session/station.h"
#include "simulation/scene.h"
#include "sweep/hand_path.h"
#include "sweep/sweep_facts.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cstdio>
#include <vector>

namespace chiron::tests {

namespace {

using core::Vec3;

/// The largest number of that name anywhere in the level's content; nothing if it has none.
std::optional<double> inContent(const QJsonValue& value, const QString& key) {
    std::optional<double> found;
    const auto take = [&found](std::optional<double> other) {
        if (other && (!found || *other > *found))
            found = other;
    };
    if (value.isArray())
        for (const QJsonValue& item : value.toArray())
            take(inContent(item, key));
    const QJsonObject object = value.toObject();
    for (auto it = object.begin(); it != object.end(); ++it) {
        if (it.key() == key && it.value().isDouble())
            take(it.value().toDouble());
        take(inContent(it.value(), key));
    }
    return found;
}

LevelNumbers numbersOf(const catalogue::ExerciseLevel& level) {
    const QJsonObject all = QJsonDocument::fromJson(QByteArray::fromStdString(level.resolvedJson)).object();
    LevelNumbers numbers;
    numbers.yield_N = inContent(all, QStringLiteral("yield_force_N")).value_or(0.0);
    numbers.yield_Nm = inContent(all, QStringLiteral("yield_torque_mN_m")).value_or(0.0) / 1000.0;
    numbers.fall_ms = inContent(all, QStringLiteral("yield_fall_ms")).value_or(numbers.fall_ms);
    numbers.bristle_N_per_m = inContent(all, QStringLiteral("bristle_stiffness_N_per_m")).value_or(0.0);
    numbers.damping_Ns_per_m = inContent(all, QStringLiteral("damping_N_s_per_m")).value_or(0.0) +
                               inContent(all, QStringLiteral("viscosity_N_s_per_m")).value_or(0.0);
    SweepFacts::complete(level, numbers);
    return numbers;
}

/// One tool's tick before.
struct Before {
    bool known = false;
    Vec3 p = Vec3::Zero(), force = Vec3::Zero(), v = Vec3::Zero(), torque = Vec3::Zero(), w = Vec3::Zero();
    core::Quat q = core::Quat::Identity();
};

class Sweep {
public:
    Sweep(const catalogue::ExerciseLevel& level, const SweepSettings& settings)
        : m_settings(settings), m_numbers(numbersOf(level)) {
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
        m_result.limit_Nm = m_kind->torqueLimit_Nm(level);
        m_result.yieldStated = m_numbers.yield_N > 0.0;
        if (m_result.yieldStated)
            m_result.yieldForce_N = m_numbers.yield_N;
        m_result.yieldTorque_Nm = m_numbers.yield_Nm;
    }

    SweepResult run() {
        for (int path = m_settings.firstPath; path < m_settings.firstPath + m_settings.paths; ++path) {
            if (path % m_settings.pathsPerScene == 0 || m_out.phase == core::TrialPhase::finished)
                appear(path);
            follow(static_cast<std::uint64_t>(path));
        }
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
        m_scene = m_kind->makeScene(m_setup);
        m_out = {};
        m_met.fill(std::nullopt);
        m_guess = core::Random::stream(m_setup.seed, "sweep guess");
        m_before.assign(m_reach.size(), {});
        m_bitsBefore = {};
        m_stiffnessBefore = 0.0;
        m_open = false;
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
        return Vec3(m_guess.uniform(-0.05, 0.05), m_guess.uniform(-0.05, 0.05),
                    m_guess.uniform(-0.02, 0.04)); // scenes lie about the origin of W
    }

    void follow(std::uint64_t path) {
        const int ticks = static_cast<int>(m_settings.path_s / core::kTickSeconds);
        for (int tick = 0; tick < ticks; ++tick) {
            for (std::size_t i = 0; i < m_hands.size(); ++i)
                m_in.tools.tools[i] = m_hands[i].step(lure(i), m_out.tissue.tools[i].force != Vec3::Zero());
            m_scene->respond(m_ticks.next(0), m_in, m_out);
            look(path, static_cast<std::uint64_t>(tick));
            if (m_settings.witness)
                m_settings.witness(path, static_cast<std::uint64_t>(tick), m_out);
        }
    }

    static void keep(Worst& worst, double value, std::uint64_t path, std::uint64_t tick, std::size_t tool,
                     const Vec3& p) {
        if (value > worst.value)
            worst = {value, path, tick, tool, p};
    }

    void look(std::uint64_t path, std::uint64_t tick) {
        ++m_result.ticks;
        const bool stored = m_out.storedEnergy_J != 0.0 || m_out.contactStiffness_N_per_m != 0.0;
        const double stiffest = std::max(m_out.contactStiffness_N_per_m, m_stiffnessBefore);
        const bool appeared =
            (m_out.events & core::event_bits::kSceneChanged) != 0 || m_out.phase != m_phaseBefore;
        const double escaped = bodiesMoved();
        const std::vector<Ends> otherEnds = endsMoved();
        bool touching = false;
        double work = 0.0;
        for (std::size_t i = 0; i < m_before.size(); ++i) {
            const core::ToolState& tool = m_in.tools.tools[i];
            const Vec3 force = m_out.tissue.tools[i].force;
            const double size = force.norm();
            m_result.finite =
                m_result.finite && force.allFinite() && m_out.tissue.tools[i].torque.allFinite();
            touching = touching || size > 0.0;
            keep(m_result.force, size, path, tick, i, tool.p_WT);
            keep(m_result.torque, m_out.tissue.tools[i].torque.norm(), path, tick, i, tool.p_WT);
            if (!stored)
                keep(m_result.inAir, size, path, tick, i, tool.p_WT);
            const std::uint8_t bits = m_out.contact[i];
            m_result.beyondChecked += (bits & core::contact_bits::kBeyondChecked) != 0 ? 1 : 0;
            m_result.yields += (bits & core::contact_bits::kYielded) != 0 ? 1 : 0;
            if (size == 0.0 && bits == 0)
                m_clear[i] = tool.p_WT;
            if (size > 0.0 && bits == 0)
                m_met[i] = tool.p_WT;
            Before& before = m_before[i];
            if (before.known && !appeared) {
                const Vec3 moved = tool.p_WT - before.p;
                const Ends& others = otherEnds[i];
                const double faded = m_numbers.damping_Ns_per_m *
                                     (std::max(tool.v_WT.norm(), before.v.norm()) + others.speed_m_per_s) /
                                     m_numbers.fade_m;
                const double allowed =
                    m_numbers.breaks_N_per_ms +
                    m_numbers.largest_Ns_per_m * ((tool.v_WT - before.v).norm() + others.sped_m_per_s) +
                    (stiffest + m_numbers.bristle_N_per_m + faded) * (moved.norm() + escaped + others.way_m);
                const double change = (force - before.force).norm();
                const double turned = turnChange(before, tool, m_out.tissue.tools[i].torque, allowed);
                if (((bits | m_bitsBefore[i]) & core::contact_bits::kThrough) != 0) {
                    keep(m_result.fall,
                         change - allowed - kSteepest * m_result.yieldForce_N / m_numbers.fall_ms, path, tick,
                         i, tool.p_WT);
                    keep(m_result.torqueFall,
                         turned - kSteepest * m_result.yieldTorque_Nm / m_numbers.fall_ms, path, tick, i,
                         tool.p_WT);
                } else {
                    keep(m_result.change, change - allowed, path, tick, i, tool.p_WT);
                    keep(m_result.torqueChange, turned, path, tick, i, tool.p_WT);
                }
                work += 0.5 * (force + before.force).dot(moved);
            }
            before = {true, tool.p_WT, force, tool.v_WT, m_out.tissue.tools[i].torque, tool.w_WT, tool.q_WT};
            m_bitsBefore[i] = bits;
        }
        m_result.touching += touching ? 1 : 0;
        count(touching, appeared, work, path, tick);
        m_stiffnessBefore = m_out.contactStiffness_N_per_m;
        m_phaseBefore = m_out.phase;
    }

    /// Of a tube, what the other hands do to it while this one holds still: what stretches it is the way
    /// between them.
    struct Ends {
        double way_m = 0.0, speed_m_per_s = 0.0, sped_m_per_s = 0.0;
    };
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

    /// By how much the torque changed more than it may; `allowed_N`: what the force may change by.
    double turnChange(const Before& before, const core::ToolState& tool, const Vec3& torque,
                      double allowed_N) const {
        constexpr double kLeaning = 4.0 / 3.0; // 1/cos² of 30°, as far as tilts are checked
        const double turn = before.q.angularDistance(tool.q_WT), way = (tool.p_WT - before.p).norm();
        const double spin = m_numbers.largest_Ns_per_m * m_numbers.shaft_m * m_numbers.shaft_m *
                            (tool.w_WT - before.w).norm();
        return (torque - before.torque).norm() -
               kLeaning * (m_numbers.turn_Nm_per_rad * turn + m_numbers.turn_Nm_per_m * way) -
               m_numbers.shaft_m * allowed_N - spin;
    }

    /// How far any loose object went since the tick before, m: the way is that between tool and object.
    double bodiesMoved() {
        double most = 0.0;
        const core::LaparoscopyCues& cues = m_out.cues.exercise.of<core::LaparoscopyCues>();
        for (std::size_t i = 0; i < static_cast<std::size_t>(cues.bodies); ++i) {
            const Vec3 p(cues.body[i].p_W[0], cues.body[i].p_W[1], cues.body[i].p_W[2]);
            most = std::max(most, (p - m_bodies[i]).norm());
            m_bodies[i] = p;
        }
        return most;
    }

    /// Books over one contact of all tools, from nothing stored to nothing stored: closed, they say what the
    /// law made.
    void count(bool touching, bool appeared, double work, std::uint64_t path, std::uint64_t tick) {
        const bool idle = !touching && m_out.storedEnergy_J == 0.0;
        if (m_open && !appeared)
            m_work_J += work;
        if (m_open && idle && !appeared)
            keep(m_result.made, m_work_J, path, tick, 0, m_in.tools.tools[0].p_WT);
        if (idle || appeared)
            m_work_J = 0.0;
        m_open = (m_open || idle) && !appeared;
    }

    SweepSettings m_settings;
    LevelNumbers m_numbers;
    const session::ExerciseKind* m_kind = nullptr;
    session::SessionSetup m_setup;
    std::vector<ToolReach> m_reach;
    std::vector<HandPath> m_hands; ///< after what they reach
    std::unique_ptr<simulation::IScene> m_scene;
    simulation::SceneInput m_in;
    simulation::SceneOutput m_out;
    realtime::TickSource m_ticks;
    std::vector<Before> m_before;
    std::array<std::uint8_t, core::kMaxTools> m_bitsBefore{};
    std::array<Vec3, core::kMaxTools> m_clear{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                              Vec3::Zero()}; ///< where each touched nothing last
    std::array<Vec3, core::LaparoscopyCues::kMaxBodies> m_bodies{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                                                 Vec3::Zero()};
    std::array<std::optional<Vec3>, core::kMaxTools> m_met; ///< where each last touched tissue that was whole
    core::Random m_guess = core::Random::stream(0, "sweep guess");
    std::size_t m_wayAt = 0;
    double m_stiffnessBefore = 0.0;
    core::TrialPhase m_phaseBefore = core::TrialPhase::idle;
    bool m_open = false; ///< the books began with nothing stored
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
           "in air N   made uJ   T max mNm  yields at  over bound  over fall   yields  beyond %  contact %";
}

std::string SweepResult::line() const {
    char text[480];
    const double all = static_cast<double>(std::max<std::uint64_t>(1, ticks));
    std::snprintf(text, sizeof text,
                  "%-40s %8.3f  %11.2f  %17.3f  %10.3f  %9.4f  %8.3f  %10.1f  %9.1f  %10.3f  %9.3f  %7llu  "
                  "%8.2f  %9.1f",
                  level.c_str(), shown(force), yieldForce_N, shown(change), shown(fall), shown(inAir),
                  shown(made, 1e6), shown(torque, 1e3), 1e3 * yieldTorque_Nm, shown(torqueChange, 1e3),
                  shown(torqueFall, 1e3), static_cast<unsigned long long>(yields),
                  100.0 * static_cast<double>(beyondChecked) / all,
                  100.0 * static_cast<double>(touching) / all);
    return std::string(text) + "\n    F" + at(force) + "  change" + at(change) + "  fall" + at(fall) +
           "  air" + at(inAir) + "  T" + at(torque) + "  T change" + at(torqueChange);
}

} // namespace chiron::tests
