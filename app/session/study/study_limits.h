// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device_descriptor.h"
#include "psychophysics/study/study_design.h"

#include <optional>
#include <string>

namespace chiron::session {

/// What a connected device can render passively.
struct RenderingLimits {
    double largestStiffness_N_per_m = 0.0; ///< K = b/(T/2 + t_d), devices.md §6
    double largestViscosity_Ns_per_m = 0.0; ///< the device's own bound b_max
    double largestForce_N = 0.0;
    double delay_s = 0.0;                  ///< t_d it was computed with
    bool measured = false;                 ///< t_d was measured; else it is the device's stated one
};

/// Of a device: K < (b + B)/(T/2 + t_d) with b = 2 N·s/m of arm and mechanism and B = 0, T = 1 ms, t_d the measured delay (0: taken as one
/// device period). Force: its continuous one, the site's cap at most. A device that renders no force has no limits here (infinite).
RenderingLimits renderingLimits(const devices::DeviceDescriptor& device, double delay_s = 0.0);

/// The delay that a device states, on the safe side: what it sends may be one period old, and what it is sent may wait for one more. 0 where
/// it is stepped in the tick.
double statedDelay_s(const devices::DeviceDescriptor& device);
/// The same limits with the measured delay; where it was never measured (or is no number) with the stated one.
RenderingLimits limitsAt(const devices::DeviceDescriptor& device, std::optional<double> measuredDelay_s);

/// What is left of a condition's table on such a device.
struct LimitedTable {
    double limit = 0.0;  ///< largest |D| that is rendered; infinite where all of them are
    int candidates = 0;  ///< that are left
    std::string why;     ///< empty: nothing was left out; else "stiffness", "weight", "viscosity", "reference"
};
/// The largest multiple of the task counts: a difference whose value the device cannot render passively or without saturation is
/// never shown. `why` "reference": not even the reference (candidates 0).
LimitedTable limitedTable(const psychophysics::Condition& condition, const RenderingLimits& limits);
/// The same where experimenters are blind: what is left in every condition with this table, as what is left of one would tell which it is.
LimitedTable blindTable(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition, const RenderingLimits& limits);

} // namespace chiron::session
