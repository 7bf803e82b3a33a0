// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device_descriptor.h"
#include "psychophysics/study/study_design.h"

#include <optional>
#include <string>

namespace chiron::session {

/// The values that a connected device can render passively.
struct RenderingLimits {
    double largestStiffness_N_per_m = 0.0;  ///< K = b/(T/2 + t_d), devices.md §6
    double largestViscosity_Ns_per_m = 0.0; ///< the device's own bound b_max
    double largestForce_N = 0.0;
    double delay_s = 0.0;  ///< the t_d used
    bool measured = false; ///< t_d was measured; if false, it is the delay that the device
                           ///< states
};

/// The limits of a device: K < (b + B)/(T/2 + t_d) with b = 2 N·s/m of arm and mechanism and B = 0, T = 1 ms,
/// and t_d the measured delay (0: one device period is assumed). The force is the device's continuous one, at
/// most the site's cap. A device that renders no force has no limits here (infinite).
RenderingLimits renderingLimits(const devices::DeviceDescriptor& device, double delay_s = 0.0);

/// The delay that a device states, on the safe side: a sample may be one period old, and a command may wait
/// for one more. 0 if the device is stepped in the tick.
double statedDelay_s(const devices::DeviceDescriptor& device);
/// The same limits with the measured delay; with the stated one if it was never measured or is NaN.
RenderingLimits limitsAt(const devices::DeviceDescriptor& device, std::optional<double> measuredDelay_s);

/// The part of a condition's table that such a device can render.
struct LimitedTable {
    double limit = 0.0; ///< largest |D| that is rendered; infinite if all are rendered
    int candidates = 0; ///< number of candidates left
    std::string why;    ///< empty: nothing was left out; else "stiffness", "weight", "viscosity", "reference"
};
/// Limits a table by the largest multiple of the task: a difference whose value the device cannot render
/// passively or without saturation is never shown. `why` is "reference" if not even the reference can be
/// rendered (candidates 0).
LimitedTable limitedTable(const psychophysics::Condition& condition, const RenderingLimits& limits);
/// The same for blind experimenters: the part that is left in every condition with this table, because a
/// condition's own remaining part would reveal which one it is.
LimitedTable blindTable(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
                        const RenderingLimits& limits);

} // namespace chiron::session
