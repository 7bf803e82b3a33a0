// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "unit/haptics/safety_oracle.h"
#include "unit/haptics/safety_random_setup.h"
#include "unit/haptics/safety_rig.h"

#include <bit>
#include <limits>

namespace chiron::test {

enum class PacketKind { good, silent, notFinite, quaternion, jump, old, sameNumber, invalid };

/// core::Random devices, settings, hands, scenes, packets and commands; one seed is one episode.
class SafetyEpisode {
public:
    SafetyEpisode(std::uint64_t seed, haptics::GuardMask mask)
        : m_random(seed), m_devices(randomDevices(m_random)), m_settings(randomSettings(m_random)),
          m_oracle(m_settings, m_devices) {
        m_supervisor.setGuardMaskForTests(mask);
        std::vector<haptics::SafetyTool> tools;
        for (const auto& device : m_devices) {
            tools.push_back({device, m_kinematics, {}});
        }
        m_configured = m_supervisor.configure(m_settings, tools).has_value();
        m_states.count = count();
        m_scene.tissue.count = count();
        for (auto& sample : m_samples) {
            sample.packet =
                m_random.below(4) == 0 ? 0xffffff00u : static_cast<std::uint32_t>(m_random.next());
        }
        m_wild = m_random.uniform() < 0.5 ? 0.0 : m_random.uniform(0.0, 0.02);
    }

    /// The broken row, or empty.
    std::string tick() {
        if (!m_configured) {
            return "configure";
        }
        const realtime::HapticTick now = m_source.next(m_now_us * 1000);
        OracleTick seen;
        std::string broken;
        makeCommands(seen);
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            const std::string wrong = packet(now, i, seen);
            broken = broken.empty() ? wrong : broken;
            move(i);
            touch(i);
            seen.requested[i] = m_scene.tissue.tools[i];
            seen.states[i] = m_states.tools[i];
        }
        makeScene(seen);
        const haptics::SafetyInput in{m_states, m_scene, seen.commands, seen.heartbeatAge_ms};
        m_supervisor.limit(now, in, m_out);
        hash();
        const bool wasLatched = m_latched;
        m_latched = m_out.force == core::ForceState::stopped || m_out.force == core::ForceState::fault;
        if (wasLatched && !m_latched) {
            for (std::size_t i = 0; i < m_devices.size(); ++i) {
                m_startAfresh[i] = m_startAfresh[i] || renders(i); // any sane packet may become the reference
            }
        }
        const std::string rule = m_oracle.check(seen, m_out);
        m_seenLive = m_seenLive || m_out.gain > 0.9;
        m_now_us += 1000;
        return broken.empty() ? rule : broken;
    }

    std::uint64_t digest() const { return m_digest; }
    bool everLive() const { return m_seenLive; }

private:
    static constexpr double kInf = std::numeric_limits<double>::infinity();
    static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

    int count() const { return static_cast<int>(m_devices.size()); }
    bool renders(std::size_t i) const {
        return m_devices[i].rendersForce && m_devices[i].period_us <= m_settings.slowestRendering_us;
    }
    bool chance(double p) { return m_random.uniform() < p; }

    void makeCommands(OracleTick& seen) {
        std::size_t n = 0;
        const auto add = [&](core::CommandKind kind, double p) {
            if (n < seen.commands.size() && chance(p)) {
                seen.commands[n++].kind = kind;
            }
        };
        add(core::CommandKind::stopForce, 0.0005);
        add(core::CommandKind::pause, 0.001);
        add(core::CommandKind::resume, 0.02);
        add(core::CommandKind::rearm, 0.03);
        add(core::CommandKind::confirmHold, 0.01);
        if (chance(0.0005)) { // a storm: two random ones
            for (core::Command& command : seen.commands) {
                command.kind = static_cast<core::CommandKind>(m_random.below(12));
            }
        }
        m_frozen = m_frozen ? !chance(0.01) : chance(0.001);
        seen.heartbeatAge_ms =
            static_cast<std::uint16_t>(m_frozen ? 250 + m_random.below(65000) : m_random.below(250));
        m_quietFor = m_quietFor > 0 ? m_quietFor - 1 : (chance(0.004) ? 8 : 0);
    }

    PacketKind kindOf(std::size_t i) {
        if (m_silentFor[i] > 0) {
            --m_silentFor[i];
            return PacketKind::silent;
        }
        if (chance(0.002)) {
            m_silentFor[i] = static_cast<int>(m_random.below(45));
        }
        if (m_badFor[i] == 0 && !chance(0.003)) {
            return PacketKind::good;
        }
        m_badFor[i] = m_badFor[i] > 0 ? m_badFor[i] - 1 : static_cast<int>(m_random.below(4));
        return static_cast<PacketKind>(2 + m_random.below(6));
    }

    std::string packet(const realtime::HapticTick& now, std::size_t i, OracleTick& seen) {
        if (m_startAfresh[i]) { // after a re-arm; an input-only tool after three bad packets
            m_startAfresh[i] = false;
            m_badInARow[i] = 0;
            m_hasReference[i] = false;
            m_isNew[i] = true;
        }
        const PacketKind kind = m_isNew[i] ? PacketKind::good : kindOf(i);
        m_isNew[i] = false;
        core::ToolState pose_D = m_pose[i];
        core::DeviceSample& sample = m_samples[i];
        if (kind != PacketKind::silent) {
            sample.buttons =
                (chance(0.0003) ? core::kButtonStop : 0u) | (chance(0.9) ? core::kButtonDeadMan : 0u);
            sample.status = chance(0.0001) ? core::sample_status::kDeviceFault : 0u;
            sample.deviceTime_us += 1000;
            m_arrival_us[i] = m_now_us - static_cast<std::int64_t>(m_random.below(2000));
            corrupt(kind, i, sample, pose_D);
        }
        const auto age = static_cast<std::uint32_t>(m_now_us - m_arrival_us[i]);
        const haptics::Admission verdict = m_supervisor.admit(now, static_cast<int>(i), sample, pose_D, age);
        const std::string wrong = judge(kind, i, verdict);
        if (verdict == haptics::Admission::fresh) {
            m_lastGood[i] = sample.packet;
            m_goodArrival_us[i] = m_arrival_us[i];
            m_pose[i].p_WT = pose_D.p_WT;
            m_hasReference[i] = true;
            m_everGood[i] = true;
        }
        seen.stopButton = seen.stopButton || (sample.buttons & core::kButtonStop) != 0;
        seen.deadMan = true; // the oracle's bound is an upper one: held or not is the supervisor's to know
        if (renders(i)) {
            seen.deviceFault = seen.deviceFault || (sample.status & core::sample_status::kDeviceFault) != 0;
        }
        seen.badInARow[i] = m_badInARow[i];
        seen.goodAge_us[i] = m_everGood[i] ? static_cast<std::uint32_t>(m_now_us - m_goodArrival_us[i]) : 0;
        return wrong;
    }

    void corrupt(PacketKind kind, std::size_t i, core::DeviceSample& sample, core::ToolState& pose_D) {
        const std::array<double, 4> rubbish{kNaN, kInf, -kInf, 1e308};
        sample.packet = m_lastGood[i] + 1 + static_cast<std::uint32_t>(m_badInARow[i]);
        if (!m_hasReference[i] && !m_everGood[i]) {
            sample.packet = m_samples[i].packet;
        }
        pose_D.p_WT +=
            0.001 *
            core::Vec3(m_random.normal(), m_random.normal(), m_random.normal()).cwiseMin(4).cwiseMax(-4);
        switch (kind) {
        case PacketKind::notFinite:
            pose_D.p_WT[0] = rubbish[m_random.below(3)];
            break;
        case PacketKind::quaternion:
            pose_D.q_WT.coeffs() *= chance(0.5) ? 1.011 : rubbish[m_random.below(4)];
            break;
        case PacketKind::jump:
            pose_D.p_WT[1] += chance(0.2) ? 1e308 : m_random.uniform(5.0, 100.0);
            break;
        case PacketKind::old:
            sample.packet = m_lastGood[i] - static_cast<std::uint32_t>(m_random.below(1u << 30));
            break;
        case PacketKind::sameNumber:
            sample.packet = m_lastGood[i];
            break;
        case PacketKind::invalid:
            sample.status |= core::sample_status::kInvalid;
            break;
        default:
            break;
        }
    }

    /// Admitting what must be refused breaks "sanity"; so does refusing what is good.
    std::string judge(PacketKind kind, std::size_t i, haptics::Admission verdict) {
        if (kind == PacketKind::silent) {
            return verdict == haptics::Admission::dropped ? "sanity" : "";
        }
        const bool needsReference =
            kind == PacketKind::jump || kind == PacketKind::old || kind == PacketKind::sameNumber;
        const bool good = kind == PacketKind::good || (needsReference && !m_hasReference[i]);
        m_badInARow[i] = good ? 0 : m_badInARow[i] + 1;
        if (needsReference && !m_hasReference[i]) {
            return verdict == haptics::Admission::fresh ? "" : "sanity";
        }
        if (!renders(i) && m_badInARow[i] >= 3) {
            m_startAfresh[i] = true;
        }
        return (verdict == haptics::Admission::fresh) == good ? "" : "sanity";
    }

    void move(std::size_t i) {
        core::ToolState& state = m_states.tools[i];
        const double speed =
            chance(0.0005) ? m_random.uniform(1.0, 3.0) : m_random.uniform(0.0, m_calm ? 0.004 : 0.5);
        m_calm = m_calm ? !chance(0.005) : chance(0.005);
        core::Vec3 direction(m_random.normal(), m_random.normal(), m_random.normal());
        state.v_WT = speed * direction.normalized();
        state.w_WT = direction;
        state.p_WT = m_pose[i].p_WT;
    }

    void touch(std::size_t i) {
        core::Wrench& w = m_scene.tissue.tools[i];
        const core::Vec3 any(m_random.normal(), m_random.normal(), m_random.normal());
        const std::array<double, 10> odd{kNaN, kInf, -kInf, 5e-324, -1e-310, 1e308, -1e300, 1e160, 0.2, 0.0};
        if (m_quietFor > 0) {
            w = {0.05 * any.cwiseMin(2).cwiseMax(-2), 0.003 * any.cwiseMin(1).cwiseMax(-1)};
        } else if (chance(m_wild)) {
            w = {any * m_random.uniform(0.0, 100.0), any * m_random.uniform(0.0, 2.0)};
        } else if (chance(0.0003)) {
            w.force[static_cast<Eigen::Index>(m_random.below(3))] = odd[m_random.below(odd.size())];
            w.torque[static_cast<Eigen::Index>(m_random.below(3))] = odd[m_random.below(odd.size())];
        } else {
            const core::Vec3 push(0.3 * m_random.normal(), 0.3 * m_random.normal(), 3.0);
            w = {push * m_random.uniform(0.0, 2.0), any * 0.05};
        }
    }

    void makeScene(OracleTick& seen) {
        seen.sceneChanged = chance(0.0005);
        m_scene.events = seen.sceneChanged ? core::event_bits::kSceneChanged : 0u;
        const std::array<double, 6> odd{kNaN, kInf, -1.0, 5e-324, 1e300, 0.0};
        m_scene.storedEnergy_J = chance(0.001) ? odd[m_random.below(6)] : m_random.uniform(0.0, 0.01);
        m_scene.contactStiffness_N_per_m =
            chance(0.001) ? odd[m_random.below(6)] : m_random.uniform(0.0, 2000.0);
    }

    void hash() {
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                m_digest = m_digest * 0x100000001b3ULL ^
                           std::bit_cast<std::uint64_t>(m_out.tools[i].wrench_W.force[axis]) ^
                           std::bit_cast<std::uint64_t>(m_out.tools[i].wrench_D.torque[axis]);
            }
        }
        m_digest = m_digest * 0x100000001b3ULL ^ m_out.guards ^ static_cast<std::uint64_t>(m_out.force);
    }

    core::Random m_random;
    std::vector<devices::DeviceDescriptor> m_devices;
    haptics::SafetySettings m_settings;
    SafetyOracle m_oracle;
    haptics::SafetySupervisor m_supervisor;
    CartesianKinematics m_kinematics;
    realtime::TickSource m_source;
    simulation::SceneOutput m_scene;
    haptics::SafetyOutput m_out;
    core::ToolStates m_states;
    std::array<core::ToolState, core::kMaxTools> m_pose{};
    std::array<core::DeviceSample, core::kMaxTools> m_samples{};
    std::array<std::uint32_t, core::kMaxTools> m_lastGood{};
    std::array<std::int64_t, core::kMaxTools> m_arrival_us{};
    std::array<std::int64_t, core::kMaxTools> m_goodArrival_us{};
    std::array<int, core::kMaxTools> m_badInARow{};
    std::array<int, core::kMaxTools> m_silentFor{};
    std::array<int, core::kMaxTools> m_badFor{};
    std::array<bool, core::kMaxTools> m_hasReference{};
    std::array<bool, core::kMaxTools> m_everGood{};
    std::array<bool, core::kMaxTools> m_startAfresh{};
    std::array<bool, core::kMaxTools> m_isNew{true, true, true, true};
    std::int64_t m_now_us = 10'000'000;
    std::uint64_t m_digest = 0xcbf29ce484222325ULL;
    double m_wild = 0.0;
    int m_quietFor = 0;
    bool m_frozen = false;
    bool m_calm = false;
    bool m_latched = false;
    bool m_seenLive = false;
    bool m_configured = false;
};

} // namespace chiron::test
