// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/random.h"
#include "core/tool_state.h"
#include "core/units.h"
#include "devices/api/workspace_map.h"
#include "devices/kinematics_catalogue.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

/// Paths of a tool over all that its mechanism reaches, made without any force: where a hand can go, not
/// where one would.
namespace chiron::tests {

/// One instrument's reach: poses of W over the whole range of the mechanism's axes.
class ToolReach {
public:
    ToolReach(const devices::DeviceDescriptor& device, const devices::WorkspaceMapping& mapping)
        : m_device(device), m_map(mapping) {
        auto kinematics = devices::makeKinematics(device);
        if (!kinematics)
            qFatal("%s", kinematics.error().message.c_str());
        m_kinematics = std::move(*kinematics);
    }

    /// Every axis anywhere in its range; `like`: as that sample, but for one axis, so that it pushes or lifts
    /// along it.
    core::DeviceSample draw(core::Random& random, const core::DeviceSample* like = nullptr) const {
        core::DeviceSample sample = like != nullptr ? *like : core::DeviceSample{};
        const std::size_t only = like != nullptr ? random.below(m_device.axes.size()) : m_device.axes.size();
        for (std::size_t i = 0; i < m_device.axes.size(); ++i) {
            const devices::AxisDescriptor& axis = m_device.axes[i];
            if (only == i || only == m_device.axes.size())
                sample.counts[i] = static_cast<std::int32_t>(
                    std::lround(random.uniform(axis.minimum, axis.maximum) / axis.resolution));
        }
        return sample;
    }
    core::ToolState pose(const core::DeviceSample& sample) const { return m_map.pose(*m_kinematics, sample); }

private:
    devices::DeviceDescriptor m_device;
    devices::WorkspaceMap m_map;
    std::unique_ptr<devices::IToolKinematics> m_kinematics;
};

/// One tool that goes from pose to pose, straight on, each way begun and ended at rest and at an even speed
/// between, up to 0.3 m/s and 3 rad/s; its jaws open and close on the way.
class HandPath {
public:
    static constexpr double kFastest_m_per_s = 0.3;
    static constexpr double kFastest_rad_per_s = 3.0;
    static constexpr double kJaw_rad_per_s = 4.0;
    static constexpr double kOpen_rad = 1.2;

    HandPath(const ToolReach& reach, core::Random random) : m_reach(reach), m_random(random) { drawStart(); }

    /// Another place to begin at: for when the first one lies in tissue, where no hand can begin.
    void drawStart() {
        m_sample = m_reach.draw(m_random);
        m_now = m_from = m_to = m_reach.pose(m_sample);
        m_now.jaw_rad = kOpen_rad;
    }

    /// The next way begins here when the present one is done; `lure`: a place that is worth going to
    /// (something to grasp, or out of what gave way, or where something was touched); `touching`: short ways
    /// are likelier, as one presses and rubs.
    const core::ToolState& step(const std::optional<core::Vec3>& lure, bool touching) {
        if (m_t >= m_duration_s)
            begin(lure, touching);
        m_t += core::kTickSeconds;
        const double x = std::min(1.0, m_t / m_duration_s), s = wayAt(x);
        const double rate = x < 1.0 ? speedAt(x) / m_duration_s : 0.0;
        m_now.p_WT = m_from.p_WT + s * (m_to.p_WT - m_from.p_WT);
        m_now.v_WT = rate * (m_to.p_WT - m_from.p_WT);
        m_now.q_WT = m_from.q_WT.slerp(s, m_to.q_WT);
        const Eigen::AngleAxisd turn(m_to.q_WT * m_from.q_WT.conjugate());
        m_now.w_WT = rate * turn.angle() * turn.axis();
        m_now.jaw_rad += std::clamp(m_jaw_rad - m_now.jaw_rad, -kJaw_rad_per_s * core::kTickSeconds,
                                    kJaw_rad_per_s * core::kTickSeconds);
        return m_now;
    }
    const core::ToolState& now() const { return m_now; }

private:
    static constexpr double kRamp = 0.2;                 ///< of a way's time, at either end
    static constexpr double kMost = 1.0 / (1.0 - kRamp); ///< of speed over mean speed
    static double speedAt(double x) {
        const double u = std::min({1.0, x / kRamp, (1.0 - x) / kRamp});
        return kMost * u * u * (3.0 - 2.0 * u);
    }
    static double wayAt(double x) {
        if (x > 0.5)
            return 1.0 - wayAt(1.0 - x);
        const double u = x / kRamp;
        return kMost * (x < kRamp ? kRamp * u * u * u * (1.0 - 0.5 * u) : x - 0.5 * kRamp);
    }

    void begin(const std::optional<core::Vec3>& lure, bool touching) {
        m_from = m_now;
        m_from.v_WT = m_from.w_WT = core::Vec3::Zero();
        m_to = m_now;
        constexpr double kThere_m = 0.002;
        if (m_atLure && (!lure || (*lure - m_now.p_WT).norm() <
                                      kThere_m)) { // what was gone to is grasped, and kept for some ways
            m_atLure = false;
            m_waysHeld = 8;
            m_jaw_rad = 0.0;
            m_duration_s = kOpen_rad / kJaw_rad_per_s;
            m_t = 0.0;
            return;
        }
        const bool holding = m_waysHeld > 0;
        m_waysHeld -= holding ? 1 : 0;
        const std::uint64_t drawn = m_random.below(8),
                            kind = drawn < 4 ? drawn : (touching || holding ? 1 : (lure ? 0 : drawn - 4));
        if (lure && (m_atLure || (kind == 0 && !holding))) { // once more where it moved meanwhile
            m_to.p_WT = *lure;
            m_jaw_rad = kOpen_rad;
            m_atLure = true;
        } else if (kind == 1) {                           // a short way, as one presses or rubs
            const double way_m = holding ? 0.030 : 0.010; // or pulls at what it holds
            for (int axis = 0; axis < 3; ++axis)
                m_to.p_WT[axis] += m_random.uniform(-way_m, way_m);
            m_jaw_rad = 0.0;
        } else {
            m_sample = m_reach.draw(m_random, kind == 2 ? &m_sample : nullptr);
            const core::ToolState goal = m_reach.pose(m_sample);
            m_to.p_WT = goal.p_WT;
            m_to.q_WT = goal.q_WT;
            m_jaw_rad = holding || m_random.below(2) == 0 ? m_jaw_rad : m_random.uniform(0.0, kOpen_rad);
        }
        const double speed =
            kFastest_m_per_s * std::pow(10.0, -m_random.uniform(0.0, 1.0)); // 0.03 to 0.3 m/s at its fastest
        const double way_s = kMost * (m_to.p_WT - m_from.p_WT).norm() / speed;
        const double turn_s = kMost * m_from.q_WT.angularDistance(m_to.q_WT) / kFastest_rad_per_s;
        m_duration_s = std::max({way_s, turn_s, 0.05});
        m_t = 0.0;
    }

    const ToolReach& m_reach;
    core::Random m_random;
    core::DeviceSample m_sample;
    core::ToolState m_from, m_to, m_now;
    double m_duration_s = 0.0;
    double m_t = 0.0;
    double m_jaw_rad = kOpen_rad;
    bool m_atLure = false;
    int m_waysHeld = 0; ///< so many more ways with closed jaws
};

} // namespace chiron::tests
