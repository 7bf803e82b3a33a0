// SPDX-License-Identifier: GPL-3.0-or-later
// Destructors of the inputs. A deleting destructor frees memory, so it is kept out of the objects with tick
// code.
#include "haptics/live_inputs.h"
#include "haptics/recorded_inputs.h"

namespace chiron::haptics {

LiveInputs::~LiveInputs() = default;
RecordedInputs::~RecordedInputs() = default;

} // namespace chiron::haptics
