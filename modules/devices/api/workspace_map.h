// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/tool_state.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"

namespace chiron::devices {

/// Applies a WorkspaceMapping: p_WT = o + s·R·H·p_DT with H = diag(-1,1,1) for a left-handed workspace,
/// otherwise 1, and R the rotation of the device's base. Velocities are scaled like positions. Angular
/// velocity, torque and the axis of a rotation are axial vectors: under the reflection H they map with
/// det(H)·H, and an orientation with R_W = R H R_D H, which remains a rotation. Forces go back through (R H)ᵀ
/// unscaled. Under H a tool's x_W = −H x_D while its normal is H n_D; of a fingertip platform's lean,
/// therefore, roll = l·x changes sign and pitch = −l·(n × x) does not (models.md §3). R turns tool and normal
/// alike and changes neither. A base that is not turned maps to the same bits as if there were no R. Pure.
/// Thread: any.
class WorkspaceMap {
public:
    explicit WorkspaceMap(const WorkspaceMapping& mapping = {}) noexcept
        : m_origin(mapping.origin_m[0], mapping.origin_m[1], mapping.origin_m[2]), m_scale(mapping.scale),
          m_polar(mapping.leftHanded ? -1.0 : 1.0, 1.0, 1.0),
          m_axial(mapping.leftHanded ? core::Vec3(1.0, -1.0, -1.0) : core::Vec3(1.0, 1.0, 1.0)),
          m_turned(mapping.turned()),
          m_turn(core::Quat(mapping.q_WD[0], mapping.q_WD[1], mapping.q_WD[2], mapping.q_WD[3]).normalized()),
          m_R(m_turn.toRotationMatrix()) {}

    core::Vec3 pointToW(const core::Vec3& p_DT) const noexcept {
        return m_origin + m_scale * turned(m_polar.cwiseProduct(p_DT));
    }
    core::Vec3 pointToD(const core::Vec3& p_WT) const noexcept {
        return m_polar.cwiseProduct(turnedBack(p_WT - m_origin)) / m_scale;
    }
    core::Vec3 velocityToW(const core::Vec3& v_DT) const noexcept {
        return m_scale * turned(m_polar.cwiseProduct(v_DT));
    }
    core::Vec3 angularToW(const core::Vec3& w_DT) const noexcept {
        return turned(m_axial.cwiseProduct(w_DT));
    }
    core::Quat orientationToW(const core::Quat& q) const noexcept {
        return m_turned ? core::Quat(m_turn * reflected(q)) : reflected(q);
    }
    core::Quat orientationToD(const core::Quat& q) const noexcept {
        return m_turned ? reflected(core::Quat(m_turn.conjugate() * q)) : reflected(q);
    }
    core::Wrench wrenchToD(const core::Wrench& w_W) const noexcept {
        return {m_polar.cwiseProduct(turnedBack(w_W.force)), m_axial.cwiseProduct(turnedBack(w_W.torque))};
    }
    core::Wrench wrenchToW(const core::Wrench& w_D) const noexcept {
        return {turned(m_polar.cwiseProduct(w_D.force)), turned(m_axial.cwiseProduct(w_D.torque))};
    }
    core::DisplayPose displayToD(const core::DisplayPose& pose) const noexcept {
        return {pose.normalForce_N, pose.pitch_rad, m_polar.x() * pose.roll_rad};
    }
    core::DisplayPose displayToW(const core::DisplayPose& pose) const noexcept { return displayToD(pose); }

    /// Returns the pose of the tool in W from one packet; velocities stay zero.
    core::ToolState pose(const IToolKinematics& kinematics, const core::DeviceSample& sample) const noexcept {
        core::ToolState tool = kinematics.pose(sample);
        tool.p_WT = pointToW(tool.p_WT);
        tool.q_WT = orientationToW(tool.q_WT);
        tool.buttons = sample.buttons;
        return tool;
    }

private:
    core::Vec3 turned(const core::Vec3& v) const noexcept { return m_turned ? core::Vec3(m_R * v) : v; }
    core::Vec3 turnedBack(const core::Vec3& v) const noexcept {
        return m_turned ? core::Vec3(m_R.transpose() * v) : v;
    }
    core::Quat reflected(const core::Quat& q) const noexcept {
        return {q.w(), m_axial.x() * q.x(), m_axial.y() * q.y(), m_axial.z() * q.z()};
    }

    core::Vec3 m_origin;
    double m_scale;
    core::Vec3 m_polar; ///< diagonal of H
    core::Vec3 m_axial; ///< diagonal of det(H)·H
    bool m_turned;
    core::Quat m_turn; ///< q_WD
    core::Mat3 m_R;
};

} // namespace chiron::devices
