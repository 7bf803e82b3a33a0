// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety_guard_mask.h"
#include "haptics/safety_settings.h"
#include "simulation/scene.h"
#include "unit/haptics/safety_rig.h"

#include <algorithm>
#include <array>
#include <vector>

namespace chiron::tests {

/// What the supervisor makes of a scene's answers while the hand goes its prescribed way, and the energy that
/// a contact has returned by then. Force is on from the first tick on (the arming stage is off), so that
/// nothing is missed; a contact counts from where nothing was touched, because whatever appears around a tool
/// brings energy that nobody put in.
class GuardedContact {
public:
    /// Devices of three forces and three torques at the hand, each with that damping budget.
    GuardedContact(const std::vector<double>& budgets_Ns_per_m, const haptics::SafetySettings& settings)
        : m_rig(devicesOf(budgets_Ns_per_m), settings,
                haptics::GuardMask::without(haptics::GuardMask::kArming)),
          m_allowed_J(settings.passivityExcess_J) {}

    double budget_Ns_per_m(std::size_t tool) const {
        return m_rig.supervisor.dampingBudget_Ns_per_m(static_cast<int>(tool));
    }

    void step(const core::ToolStates& tools, const simulation::SceneOutput& scene, bool appeared) {
        m_rig.states = tools;
        m_rig.scene = scene;
        m_rig.tick();
        const bool untouched =
            m_rig.out.energyStored_J == 0.0 && m_rig.out.energySupplied_J == 0.0 && idle(scene);
        if (appeared || untouched) {
            m_counts = untouched && !appeared && m_rig.out.gain == 1.0;
            m_held_J = m_grown_J = 0.0;
            return;
        }
        if (!m_counts)
            return;
        const double held_J = m_rig.out.energyStored_J - m_rig.out.energySupplied_J;
        m_grown_J = std::max(m_grown_J, held_J - std::max(0.0, m_held_J));
        m_held_J = held_J;
    }
    const haptics::SafetyOutput& out() const { return m_rig.out; }

    bool counts() const { return m_counts; }
    /// Energy that the open contact has given the hand beyond what the hand had put into it, J.
    double returned_J() const { return -m_rig.out.energySupplied_J; }
    double grown_J() const { return m_grown_J; } ///< the most that one tick of the open contact has brought
    /// What was returned, over what the controller allows (passivity_controller.h): 1 mJ for each body, and
    /// what one tick brings, which is seen only after it; where bodies are rendered softer, 1 mJ that is
    /// forgiven in each contact and half a millijoule that is made while the share falls (as in
    /// test_two_hands).
    double over_J(const simulation::SceneOutput& scene) const {
        constexpr double kFalling_J = 0.0005;
        const double body_J = scene.energyByBody
                                  ? m_allowed_J + haptics::PassivityController::kForgiven_J + kFalling_J
                                  : m_allowed_J;
        return returned_J() - bodiesOf(scene) * body_J - m_grown_J;
    }

private:
    static std::vector<devices::DeviceDescriptor> devicesOf(const std::vector<double>& budgets_Ns_per_m) {
        std::vector<devices::DeviceDescriptor> devices;
        for (const double budget : budgets_Ns_per_m) {
            devices.push_back(test::sixAxisDevice(20.0));
            devices.back().maximumDamping_Ns_per_m = budget;
        }
        return devices;
    }
    static bool idle(const simulation::SceneOutput& scene) {
        return std::all_of(scene.tissue.tools.begin(), scene.tissue.tools.begin() + scene.tissue.count,
                           [](const core::Wrench& wrench) {
                               return wrench.force == core::Vec3::Zero() &&
                                      wrench.torque == core::Vec3::Zero();
                           });
    }
    static double bodiesOf(const simulation::SceneOutput& scene) {
        std::array<bool, core::kMaxTools> seen{};
        for (int tool = 0; tool < scene.tissue.count; ++tool)
            seen[scene.body[static_cast<std::size_t>(tool)]] = true;
        return static_cast<double>(std::count(seen.begin(), seen.end(), true));
    }

    test::SafetyRig m_rig;
    double m_allowed_J;
    bool m_counts = false;
    double m_held_J = 0.0;  ///< stored beyond what was put in, in the tick before
    double m_grown_J = 0.0; ///< the most that one tick of this contact has added to that
};

} // namespace chiron::tests
