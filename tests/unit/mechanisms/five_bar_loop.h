// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device_sample.h"
#include "core/units.h"
#include "mechanisms/five_bar_plant.h"
#include "mechanisms/hand.h"
#include "mechanisms/wrist.h"

#include <cstdint>
#include <string_view>

namespace chiron::tests {

/// Coordinates of P1's mechanism with its tip and endoscope there.
inline mechanisms::FiveBarVector fiveBarAt(const core::Vec3& p_D, const mechanisms::EndoscopeAngles& angles) {
    const mechanisms::FiveBarPlantParameters device;
    const auto theta = *mechanisms::FiveBarKinematics(device.geometry).inverse(p_D);
    mechanisms::FiveBarVector q;
    q << theta[0], theta[1], angles.pitch - device.mountingPitch_rad, angles.yaw, angles.roll;
    return q;
}

/// P1's mechanism with hand and wrist on it, against any law of what the host sees; the law's answer is one
/// tick late.
class FiveBarLoop {
public:
    static constexpr double kToolMass_kg = 0.15;
    static constexpr double kToolInertia_kgm2 = 1.4e-3;

    /// What the host makes of the encoders.
    struct Seen {
        core::DeviceSample sample;
        core::Vec3 p_D;
        mechanisms::SphericalJoint joint;
    };

    FiveBarLoop(const mechanisms::FiveBarPlantParameters& device, const mechanisms::HandParameters& arm)
        : m_plant(device), m_host(device), m_hand(arm, 1, kToolMass_kg), m_wrist(arm, 1, kToolInertia_kgm2) {}

    void start(const core::Vec3& p_D, const mechanisms::EndoscopeAngles& angles) {
        m_plant.reset(fiveBarAt(p_D, angles));
        const mechanisms::ToolMotion tool = m_plant.motion();
        m_hand.reset(tool.p_DT, tool.q_DT);
        m_wrist.reset(tool.q_DT);
    }

    template <class Law> void tick(const Law& law, const mechanisms::HandIntention& wanted) {
        const Seen seen = look();
        const mechanisms::FiveBarVector tau = m_host.efforts(m_late);
        m_late = law(seen);
        m_plant.beginTick({tau[0], tau[1], tau[2], tau[3], tau[4]}, true);
        m_hand.beginTick(wanted);
        m_wrist.beginTick(m_hand.acting());
        const double dt = core::kTickSeconds / m_plant.substeps();
        for (int i = 0; i < m_plant.substeps(); ++i) {
            const mechanisms::ToolMotion tool = m_plant.motion();
            const core::Wrench grip{m_hand.gripForceOnTool(tool.p_DT, tool.v_DT),
                                    m_wrist.gripTorqueOnTool(tool.q_DT, tool.w_DT)};
            m_plant.step(dt, grip);
            m_hand.integrate(dt, grip.force);
            m_wrist.integrate(dt, grip.torque);
        }
        m_plant.endTick();
        ++m_ticks;
    }

    const mechanisms::FiveBarDynamics& host() const { return m_host; } ///< placed where the encoders said
    const mechanisms::FiveBarPlant& plant() const { return m_plant; }
    const mechanisms::Wrist& wrist() const { return m_wrist; }

private:
    Seen look() {
        Seen seen;
        mechanisms::FiveBarVector q;
        for (int axis = 0; axis < 5; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            seen.sample.counts[i] = m_plant.encoderCounts()[i];
            q[axis] = seen.sample.counts[i] * m_plant.parameters().resolution[i];
        }
        seen.sample.packet = static_cast<std::uint32_t>(m_ticks + 1);
        seen.sample.deviceTime_us = m_ticks * 1000;
        m_host.place(q);
        seen.p_D = mechanisms::FiveBarKinematics::toD(m_host.loop().tip);
        seen.joint = m_host.joint();
        return seen;
    }

    mechanisms::FiveBarPlant m_plant;
    mechanisms::FiveBarDynamics m_host;
    mechanisms::Hand m_hand;
    mechanisms::Wrist m_wrist;
    core::Wrench m_late;
    std::uint64_t m_ticks = 0;
};

inline mechanisms::HandParameters armNamed(const char* name) {
    const std::string_view which(name);
    mechanisms::HandParameters arm = which == "light"  ? mechanisms::HandParameters::light()
                                     : which == "firm" ? mechanisms::HandParameters::firm()
                                                       : mechanisms::HandParameters{};
    arm.tremorRms_m = 0.0;
    arm.wristTremorRms_rad = 0.0;
    return arm;
}

} // namespace chiron::tests
