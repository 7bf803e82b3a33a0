// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device_descriptor.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"

namespace chiron::session {

/// The largest displacement of the tip, m, in D, for one count of one axis, with every axis in the middle of
/// its travel. For axes in metres it is their resolution; for rotary axes it follows from the kinematics. 0
/// if the kinematics are not known. Allocates.
double tipCount_m(const devices::DeviceDescriptor& device);

/// Limits a law's friction to what a device can render (models.md §0: V₀ = max(1 mm/s, count/15 ms, μN/b_max)
/// with the device's data): b_max is the smaller one of the law's and the device's, and the count is the
/// device's at the tip. Both are in W: with a workspace scaled by k, one millimetre of the hand is k
/// millimetres in W, so a device's damping b is felt as b/k and its count is k times as large. If a device
/// does not state its count, the law's applies. Uses only data stored with a session, so that its replay has
/// the same law, bit for bit.
simulation::UrethraForceSettings onDevice(simulation::UrethraForceSettings law,
                                          const devices::DeviceDescriptor& device,
                                          const devices::WorkspaceMapping& mapping);

} // namespace chiron::session
