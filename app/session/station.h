// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base_mounting.h"
#include "core/result.h"
#include "devices/api/device.h"
#include "devices/api/hand_input.h"
#include "devices/driver_catalogue.h"
#include "mechanisms/gimbal_kinematics.h"
#include "scoring/trace_rows.h"
#include "session/exercise_kind.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::session {

/// One tool of a session: what is held, where its workspace lies in W, and where the window puts what a person does.
struct StationTool {
    std::unique_ptr<devices::IDevice> device;
    devices::WorkspaceMapping mapping;
    devices::HandInput input; ///< of `device`; empty where it is not moved through the window
};

/// The tools a session is done with. Moved, not copied.
struct Station {
    std::vector<StationTool> tools;
    std::string operatorName; ///< scripted operator or "trace:<file>"; empty: a person's own hand

    std::vector<devices::WorkspaceMapping> mappings() const; ///< one a tool
    bool felt() const noexcept; ///< whether any device renders force, as its descriptor says
    /// Of each tool that a mouse and a keyboard move as a point or a grasper, in the order of the tools.
    std::vector<devices::PointerMailbox*> pointers() const;
    devices::EndoscopeMailbox* endoscope() const noexcept; ///< of the first tool that they move as an endoscope, or nullptr
};

/// The scripted hand that holds a simulated mechanism outside of an exercise: while it is measured, and in a study without people.
struct SimulatedHand {
    std::unique_ptr<mechanisms::HandStrategy> strategy; ///< begins at devices::kHeldFrom_D
    mechanisms::HandParameters hand;
    std::uint64_t seed = 1; ///< of its tremor
    double frictionCompensation = 0.0;
    const mechanisms::GimbalPlantParameters* gimbal = nullptr; ///< DriverRequest::gimbal
};

/// One tool of the simulated mechanism with this kinematics id. Failure: wrongUse for an unknown one; badInput.
core::Result<Station> simulatedStation(std::string_view mechanism, SimulatedHand hand);

/// How a person's workspace lies in W: what the set-up screen and the command line offer. What it says takes the place of what the level
/// says of every instrument (ExerciseLevel::mounting); a left-handed one mirrors that.
using WorkspaceChoice = core::BaseMounting;

/// The mapping of a choice. Failure: badInput naming the value and its range.
core::Result<devices::WorkspaceMapping> mappingOf(const WorkspaceChoice& choice);

/// A mouse and a keyboard that move one point (class "shown"). Whatever the scale, the tool reaches the same box of W: a larger scale
/// makes the hand's part of it smaller. Failure: badInput.
core::Result<Station> keyboardMouseStation(const WorkspaceChoice& choice = {});

/// The same for a level of an exercise. An endoscope begins at the kind's endoscopeStart_W(), looking in. Several points (fingers): one
/// tool each, at the kind's places, every one with the same box round its own place, so that the fingers of a hand stay side by side at an
/// edge too. Graspers: one tool for each instrument, jaws open, above the field under their entry points; all reach the same box of W,
/// whose middle is the choice's origin. Failure: badInput; wrongUse for a level without 1..kMaxTools instruments.
core::Result<Station> keyboardMouseStation(const WorkspaceChoice& choice, const ExerciseKind& kind,
                                           const catalogue::ExerciseLevel& level);

/// The same with any driver whose devices a person moves (MovedBy::person).
core::Result<Station> personStation(const devices::Driver& driver, const WorkspaceChoice& choice, const ExerciseKind& kind,
                                    const catalogue::ExerciseLevel& level);

/// A simulated mechanism of the kind's (`mechanism`: its kinematics id; "": the usual one), one for each instrument of the level, with a scripted operator on it. Failure: that of the kind's makeOperator();
/// wrongUse for a mechanism that does not exist, or that the kind is not done on.
/// `map`: how a force becomes motor torques on P2's gimbal (models.md §2.1). `mounting`: how every base stands, instead of what the level
/// says, beside the kind's places; badInput as mappingOf(), wrongUse where the kind's scripted hands take D for W.
core::Result<Station> scriptedStation(const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                      const std::string& operatorName, std::uint64_t seed,
                                      mechanisms::PolarMap map = mechanisms::PolarMap::exact, std::string_view mechanism = {},
                                      const WorkspaceChoice& mounting = {});

/// A recorded trace as input devices (class "shown": nobody feels anything), one for each of the `tools` that the level needs;
/// rows of other tools are left out. All begin with the file's earliest row and end with its last: a tool waits where its own
/// first row has it, and stays where its last one leaves it. `tool`: the kind's pointerTool(); an endoscope needs the columns of
/// orientation, graspers the jaw's. Failure: badInput naming file and row, columns or the tool that is missing.
core::Result<Station> traceStation(const scoring::TraceRows& rows, PointerTool tool = PointerTool::point, int tools = 1);

} // namespace chiron::session
