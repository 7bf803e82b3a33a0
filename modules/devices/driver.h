// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/result.h"
#include "devices/api/device.h"
#include "devices/api/driven_axes.h"
#include "devices/api/hand_input.h"
#include "devices/api/trace_point.h"
#include "mechanisms/hand_parameters.h"
#include "mechanisms/hand_strategy.h"

#include <any>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::devices {

/// Position at which a scripted hand holds the tip of a simulated point mechanism when the device is opened.
/// Unit: m.
/// Frame: D.
inline const core::Vec3 kHeldFrom_D{0.0, 0.0, 0.05};

/// Kinematics id of P2's gimbal.
inline constexpr std::string_view kGimbalHprd = "gimbal_hprd";

/// Type of tool with which an exercise is done.
enum class ToolShape { point, endoscope, grasper };

/// Who or what moves the tools of a driver. It determines what a screen asks before a session, and whose
/// session it is.
enum class MovedBy { person, scriptedOperator, recording };

/// What a person holds to move the tools of a driver. It determines which movements a screen explains.
enum class HandKind { mouseAndKeyboard, handle };

/// One tool of a session, as requested from its driver.
struct ToolRequest {
    WorkspaceMapping mapping{}; ///< position of its workspace in W
    /// z in W at which a point tool starts; empty: the driver's default.
    std::optional<double> startHeight_m{};
    std::unique_ptr<mechanisms::HandStrategy> strategy{}; ///< MovedBy::scriptedOperator: never null
    std::vector<TracePoint> trace{};                      ///< MovedBy::recording: never empty
    /// Where its device is connected, as its driver's README says. Empty: none was named. Drivers without
    /// connected devices ignore it.
    std::string address{};
};

/// A session's request to a driver. A driver uses what concerns it and ignores the rest.
struct DriverRequest {
    ToolShape shape = ToolShape::point;
    std::vector<ToolRequest> tools;
    /// Scale of a person's workspace, 0.25 to 4; the box of W stays the same.
    double scale = 1.0;
    std::array<double, 3> middle_m{}; ///< middle of the box of W that all graspers reach
    double widestJaw_rad = 0.0;       ///< opening angle of a point tool that has a jaw; 0: no jaw
    /// Start position of an endoscope's tip, m.
    core::Vec3 endoscopeStart_W = core::Vec3::Zero();
    std::string mechanism;           ///< kinematics id, for a driver with several mechanisms
    mechanisms::HandParameters hand; ///< of a scripted operator
    std::uint64_t seed = 1;          ///< seed of its tremor
    std::string forceMap;            ///< one of KinematicsEntry::forceMaps; empty: the usual one
    /// Share of the Coulomb friction that is fed forward, 0..kMostFrictionCompensation.
    double frictionCompensation = 0.0;
    /// Tools of one hand that share an arm: tool = hand · fingersPerHand + finger.
    int fingersPerHand = 1;
    double fingerSpacing_m = 0.0; ///< distance from one pad to the next
    /// True parameters of a simulated mechanism, of the type that this mechanism's plant has
    /// (mechanisms::GimbalPlantParameters, FiveBarPlantParameters, FingertipArmParameters); those of another
    /// one are refused. Empty: the usual ones.
    std::any plant{};
};

/// A device that a driver has made. It is not open yet (IDevice::open()).
struct DriverTool {
    std::unique_ptr<IDevice> device{};
    HandInput input{}; ///< of the device
    /// An earlier tool of the request on whose base this one stands; empty: it has a base of its own.
    std::optional<std::size_t> standsOn{};
    /// The motors of a mechanism that is computed inside the program; null for every other device.
    IDrivenAxes* axes = nullptr;
};

/// A device that is present and can be used.
struct FoundDevice {
    std::string model;        ///< for people
    std::string serialNumber; ///< empty if the device reports none
    std::string address{};    ///< ToolRequest::address of the device; empty if the driver needs none
};

/// One of several ways in which a mechanism converts force to efforts.
struct ForceMap {
    std::string_view id;   ///< as the command line and its output have it
    std::string_view name; ///< for people, marked with QT_TRANSLATE_NOOP in the context Drivers
};

/// Id of the force map that conserves power. Every mechanism has it.
inline constexpr std::string_view kExactForceMap = "exact";

/// The force maps of a mechanism among which a session can choose. Static data.
struct ForceMaps {
    std::string_view title;         ///< of the choice, for people; marked like ForceMap::name
    std::span<const ForceMap> maps; ///< the usual one, kExactForceMap, comes first
    /// Returns the id of the map that a device uses.
    std::string_view (*of)(const DeviceDescriptor& descriptor);
};

/// A type of kinematics that stored sessions of a driver name.
struct KinematicsEntry {
    std::string_view id; ///< DeviceDescriptor::kinematics
    core::Result<std::unique_ptr<IToolKinematics>> (*make)(const DeviceDescriptor& descriptor);
    /// Name shown to people for the driver's devices with these kinematics, marked with QT_TRANSLATE_NOOP
    /// (core/marked_texts.h) in the context Drivers. Empty: the driver's name applies.
    std::string_view name{};
    const ForceMaps* forceMaps = nullptr; ///< null: there is only the exact one
};

/// One driver: everything that the rest of the program knows about it. Static data; its functions allocate
/// and may block, so they are not for the tick.
struct Driver {
    std::string_view id;       ///< DeviceDescriptor::driver
    std::string_view title;    ///< for the command line, English
    std::string_view needs;    ///< what must be present to use it; likewise
    std::string_view planWord; ///< name of the driver in a stored plan
    DeviceClass deviceClass;   ///< as in the descriptors of its devices
    MovedBy movedBy;
    std::span<const KinematicsEntry> kinematics;

    /// Lists the devices that are present now; empty if there is none. Never throws.
    std::vector<FoundDevice> (*discover)();
    /// Makes one tool for each that is requested, in that order.
    /// Errors: badInput or wrongUse, saying what does not fit.
    core::Result<std::vector<DriverTool>> (*open)(DriverRequest request);

    /// Name shown to people for its devices, and for the driver in lists; marked like KinematicsEntry::name.
    /// Empty: lists show the title, and a device is named by its model.
    std::string_view name{};
    /// A sentence on what must be present and what to do with it; marked likewise. Empty: `needs` is shown.
    std::string_view readiness{};
    /// For MovedBy::person. Mouse and keyboard: open() returns mailboxes as input.
    HandKind hand = HandKind::handle;
};

/// Returns the driver's kinematics with this id, or nullptr.
inline const KinematicsEntry* kinematicsOf(const Driver& driver, std::string_view id) noexcept {
    for (const KinematicsEntry& entry : driver.kinematics)
        if (entry.id == id)
            return &entry;
    return nullptr;
}

/// Returns the name shown to people for a device of the driver with these kinematics; if it is empty, use the
/// device's model.
inline std::string_view nameOf(const Driver& driver, std::string_view kinematics) noexcept {
    const KinematicsEntry* entry = kinematicsOf(driver, kinematics);
    return entry && !entry->name.empty() ? entry->name : driver.name;
}

/// Whether a mechanism with these kinematics (null: an unknown one) can convert force in this way.
inline bool hasForceMap(const KinematicsEntry* kinematics, std::string_view id) noexcept {
    if (id.empty() || id == kExactForceMap)
        return true;
    if (kinematics == nullptr || kinematics->forceMaps == nullptr)
        return false;
    for (const ForceMap& map : kinematics->forceMaps->maps)
        if (map.id == id)
            return true;
    return false;
}

/// KinematicsEntry::make for a class with a create(descriptor).
template <class Kinematics>
core::Result<std::unique_ptr<IToolKinematics>> makeKinematicsOf(const DeviceDescriptor& descriptor) {
    auto made = Kinematics::create(descriptor);
    CHIRON_TRY(made);
    return std::make_unique<Kinematics>(*made);
}

} // namespace chiron::devices
