// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/urethra_insertion/scoring/canal_series.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

#include <optional>

namespace chiron::session {

/// The motion of tool 0 of a trial relative to the urethra, sample by sample, from its stored poses and
/// tissue wrench:
/// - s, offset: of the tip's foot on the centre-line
/// - alignment: angle between the endoscope's axis and the tangent there
/// - lateral: ‖f − (f·t) t‖
/// - axial torque: |τ·a|
/// - stage and landmarks: a ProcedureTracker stepped once for every running tick that the recording has for
/// the
///   sample (ToolTrace::heldTicks), exactly as the scene steps it
/// A landmark that counted as seen during the session therefore counts as seen here, even if the device's
/// clock differs from the tick's or its packets are slower. Without ticks in the trace, the tracker makes one
/// step per sample that was not paused, by the sample's time. The stage of a sample is the one at the arrival
/// of the next sample; a landmark is seen at the time of the sample that was held. Empty if the trace has no
/// orientations. Pure function.
/// Thread: any.
std::optional<scoring::InsertionSeries>
insertionSeries(const simulation::UrethraInsertionParameters& parameters, const scoring::TrialTrace& trial);

} // namespace chiron::session
