// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device_descriptor.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"

namespace chiron::session {

/// How far one count of one axis moves the tip at most, m, in D, with every axis in the middle of its travel: of axes in metres their
/// resolution, of those that turn what their kinematics make of it. 0: the kinematics are not known. Allocates.
double tipCount_m(const devices::DeviceDescriptor& device);

/// A law's friction as a device can render it (models.md §0: V₀ = max(1 mm/s, count/15 ms, μN/b_max) with the device's data): b_max is the
/// smaller one of the law's and the device's, the count is the device's at the tip. Both are of W: with a workspace scaled by k a hand's
/// millimetre is k of W, so a device's damping b is felt as b/k and its count counts k times. A device that says nothing of its
/// count leaves the law's. From what is stored with a session alone: its replay has the same law, bit for bit.
simulation::UrethraForceSettings onDevice(simulation::UrethraForceSettings law, const devices::DeviceDescriptor& device,
                                          const devices::WorkspaceMapping& mapping);

} // namespace chiron::session
