// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base_mounting.h"
#include "core/result.h"
#include "devices/api/device.h"
#include "devices/api/hand_input.h"
#include "devices/driver_catalogue.h"
#include "scoring/trace_rows.h"
#include "session/exercise_kind.h"

#include <any>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::session {

/// One tool of a session: its device, the position of its workspace in W, and where a window sends a person's
/// input.
struct StationTool {
    std::unique_ptr<devices::IDevice> device;
    devices::WorkspaceMapping mapping;
    devices::HandInput input; ///< input of `device`; empty if the window does not move it
};

/// The tools of a session. Can be moved, not copied.
struct Station {
    std::vector<StationTool> tools;
    std::string operatorName; ///< scripted operator or "trace:<file>"; empty: a person's own hand

    std::vector<devices::WorkspaceMapping> mappings() const; ///< one per tool
    bool felt() const noexcept; ///< true if any device renders force, according to its descriptor
    /// The mailbox of each tool that mouse and keyboard move as a point or a grasper, in the order of the
    /// tools.
    std::vector<devices::PointerMailbox*> pointers() const;
    /// The mailbox of the first tool that they move as an endoscope, or nullptr.
    devices::EndoscopeMailbox* endoscope() const noexcept;
};

/// A scripted hand that holds a simulated mechanism outside of an exercise: while the mechanism is measured,
/// and in a study without people.
struct SimulatedHand {
    std::unique_ptr<mechanisms::HandStrategy> strategy; ///< starts at devices::kHeldFrom_D
    mechanisms::HandParameters hand;
    std::uint64_t seed = 1; ///< seed of its tremor
    double frictionCompensation = 0.0;
    std::any plant{}; ///< DriverRequest::plant
};

/// Makes a station with one tool of the simulated mechanism with this kinematics id.
/// Errors: wrongUse for an unknown mechanism; badInput.
core::Result<Station> simulatedStation(std::string_view mechanism, SimulatedHand hand);

/// The position of a person's workspace in W, as offered by the set-up screen and the command line. It
/// replaces the level's mounting of every instrument (ExerciseLevel::mounting); a left-handed mounting is the
/// mirror image.
using WorkspaceChoice = core::BaseMounting;

/// The mapping of a choice.
/// Errors: badInput naming the value and its range.
core::Result<devices::WorkspaceMapping> mappingOf(const WorkspaceChoice& choice);

/// A mouse and a keyboard that move one point (class "shown"). The tool reaches the same box of W at any
/// scale: a larger scale only makes the hand's share of it smaller.
/// Errors: badInput.
core::Result<Station> keyboardMouseStation(const WorkspaceChoice& choice = {});

/// The same for a level of an exercise. An endoscope starts at the exercise's toolStart_W(), looking in.
/// Several points (fingers) are one tool each at the exercise's positions, each with the same box round its
/// own position, so that the fingers of a hand stay side by side at an edge too. Graspers are one tool per
/// instrument, with open jaws, above the field under their entry points; all reach the same box of W, whose
/// centre is the choice's origin.
/// Errors: badInput; wrongUse for a level without 1..kMaxTools instruments.
core::Result<Station> keyboardMouseStation(const WorkspaceChoice& choice, const ExerciseKind& kind,
                                           const catalogue::ExerciseLevel& level);

/// The same with any driver whose devices a person moves (MovedBy::person). A device with a handle stands on
/// a base, which is mounted as for scripted hands. `addresses`: where the devices are connected, one for each
/// tool (ToolRequest::address); empty: as the driver finds them.
core::Result<Station> personStation(const devices::Driver& driver, const WorkspaceChoice& choice,
                                    const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                    std::span<const std::string> addresses = {});

/// What a scripted operator holds. The default is what is used if nobody chose.
struct ScriptedDevice {
    /// A driver whose devices scripted operators move (MovedBy::scriptedOperator).
    const devices::Driver* driver = &devices::usualDriver(devices::MovedBy::scriptedOperator);
    std::string_view mechanism{}; ///< kinematics id; "": the exercise's usual one
    /// How the mechanism converts force to efforts: one of its KinematicsEntry::forceMaps; "": the usual one.
    std::string_view forceMap{};
    /// How every base is mounted relative to the exercise's positions, instead of the level's mounting.
    WorkspaceChoice mounting{};
    const mechanisms::HandParameters* hand = nullptr; ///< the arm that holds it; null: the operator's own
};

/// A mechanism of the exercise, one for each instrument of the level, with a scripted operator on it.
/// Errors: those of makeOperator(); wrongUse for a mechanism that does not exist or that the exercise does
///   not support, and for a mounting if the scripted hands assume that D equals W; badInput as in
///   mappingOf(); those of the driver.
core::Result<Station> scriptedStation(const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                      const std::string& operatorName, std::uint64_t seed,
                                      const ScriptedDevice& held = {});

/// A recorded trace as input devices (class "shown": nobody feels anything), one for each of the `tools` that
/// the level needs; rows of other tools are ignored. All devices begin with the file's earliest row and end
/// with its last: a tool stays at the position of its own first row before that row, and at that of its last
/// row after it. `tool`: the exercise's pointerTool(); an endoscope needs the columns of orientation,
/// graspers that of the jaw. `driver`: one that plays recordings (MovedBy::recording).
/// Errors: badInput naming file and row, columns or the missing tool.
core::Result<Station>
traceStation(const scoring::TraceRows& rows, PointerTool tool = PointerTool::point, int tools = 1,
             const devices::Driver& driver = devices::usualDriver(devices::MovedBy::recording));

} // namespace chiron::session
