// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/trace.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

#include <optional>

namespace chiron::session {

/// What tool 0 of a trial did with respect to the urethra, sample by sample, from its stored poses and tissue wrench:
///   s, offset: of the tip's foot on the centre-line;  alignment: angle between the endoscope's axis and the tangent there;
///   lateral: ‖f − (f·t) t‖;  axial torque: |τ·a|;  stage and landmarks: a ProcedureTracker stepped once for every running tick
///   that the recording has for the sample (ToolTrace::heldTicks), exactly as the scene steps it: what live counted as seen is seen, also where
///   the device's clock is not the tick's or its packets are slower. A trace without ticks: one step a sample that was not paused, by its time.
///   The stage of a sample is the one when the next came; a landmark is seen at the time of the sample that was held.
/// Nothing where the trace has no orientations. Pure; any thread.
std::optional<scoring::InsertionSeries> insertionSeries(const simulation::UrethraInsertionParameters& parameters,
                                                        const scoring::TrialTrace& trial);

} // namespace chiron::session
