// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/result.h"
#include "devices/api/device.h"
#include "devices/api/hand_input.h"
#include "devices/api/trace_point.h"
#include "mechanisms/gimbal_kinematics.h"
#include "mechanisms/gimbal_plant_parameters.h"
#include "mechanisms/hand_parameters.h"
#include "mechanisms/hand_strategy.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::devices {

/// Where a scripted hand holds the tip of a simulated mechanism that is moved as a point, when it is opened: D, m.
inline const core::Vec3 kHeldFrom_D{0.0, 0.0, 0.05};

/// What kind of tool an exercise is done with.
enum class ToolShape { point, endoscope, grasper };

/// Who or what moves the tools of a driver: it decides what a screen asks before a session, and whose session it is.
enum class MovedBy { person, scriptedOperator, recording };

/// One tool of a session, as its driver is asked for it.
struct ToolRequest {
    WorkspaceMapping mapping{};                         ///< where its workspace lies in W
    std::optional<double> startHeight_m{};              ///< z in W where a point begins; empty: as the driver begins
    std::unique_ptr<mechanisms::HandStrategy> strategy{}; ///< MovedBy::scriptedOperator: never null
    std::vector<TracePoint> trace{};                    ///< MovedBy::recording: never empty
};

/// What a session asks of a driver. A driver reads what concerns it and leaves the rest.
struct DriverRequest {
    ToolShape shape = ToolShape::point;
    std::vector<ToolRequest> tools;
    double scale = 1.0;                           ///< of a person's workspace, 0.25 to 4; the box of W stays the same
    std::array<double, 3> middle_m{};             ///< of the box of W that all graspers reach
    double widestJaw_rad = 0.0;                   ///< of a point that has a jaw; 0: none
    core::Vec3 endoscopeStart_W = core::Vec3::Zero(); ///< where an endoscope's tip begins, m
    std::string mechanism;                        ///< kinematics id, for a driver with several mechanisms
    mechanisms::HandParameters hand;              ///< of a scripted operator
    std::uint64_t seed = 1;                       ///< of its tremor
    mechanisms::PolarMap map = mechanisms::PolarMap::exact; ///< how a gimbal renders force
    double frictionCompensation = 0.0;            ///< share of the Coulomb friction that is fed forward, 0 to 0.8
    int fingersPerHand = 1;                       ///< tools of one hand that share an arm: tool = hand · fingersPerHand + finger
    double fingerSpacing_m = 0.0;                 ///< from one pad to the next
    /// What a simulated gimbal is truly like, read while it is opened. Null: as it is built.
    const mechanisms::GimbalPlantParameters* gimbal = nullptr;
};

/// A device that a driver made. It is not open yet (IDevice::open()).
struct DriverTool {
    std::unique_ptr<IDevice> device{};
    HandInput input{};                         ///< of the device
    std::optional<std::size_t> standsOn{};     ///< an earlier tool of the request on whose base this one stands; empty: on its own
};

/// A device that is there to be used.
struct FoundDevice {
    std::string model;        ///< for people
    std::string serialNumber; ///< empty where the device tells none
};

/// A kind of kinematics that stored sessions of a driver name.
struct KinematicsEntry {
    std::string_view id; ///< DeviceDescriptor::kinematics
    core::Result<std::unique_ptr<IToolKinematics>> (*make)(const DeviceDescriptor& descriptor);
    /// What people call a device of the driver that has them, marked with QT_TRANSLATE_NOOP (core/marked_texts.h) in the context Drivers.
    /// Empty: as the driver's name says.
    std::string_view name{};
    /// For kinematics that can also turn force into torques by published formulas: which way a device does. Null: there is one way only.
    mechanisms::PolarMap (*mapOf)(const DeviceDescriptor& descriptor) = nullptr;
};

/// One driver: everything that the rest of the program knows of it. Static data; its functions allocate and may block, so not in
/// the tick.
struct Driver {
    std::string_view id;       ///< DeviceDescriptor::driver
    std::string_view title;    ///< for the command line, English
    std::string_view needs;    ///< what must be there to use it; likewise
    std::string_view planWord; ///< as a stored plan names it
    DeviceClass deviceClass;   ///< as the descriptors of its devices say
    MovedBy movedBy;
    std::span<const KinematicsEntry> kinematics;

    /// The devices that are there now; empty where none is. Never throws.
    std::vector<FoundDevice> (*discover)();
    /// One tool for each that is asked for, in that order. Failure: badInput or wrongUse, saying what does not fit.
    core::Result<std::vector<DriverTool>> (*open)(DriverRequest request);

    /// What people call its devices, and what stands in lists of drivers; marked as KinematicsEntry::name. Empty: lists show the title, and
    /// a device goes by its model.
    std::string_view name{};
    std::string_view readiness{}; ///< a sentence on what must be there, and what is done with it; marked likewise. Empty: `needs`
};

/// The driver's kinematics of an id, or nullptr.
inline const KinematicsEntry* kinematicsOf(const Driver& driver, std::string_view id) noexcept {
    for (const KinematicsEntry& entry : driver.kinematics)
        if (entry.id == id)
            return &entry;
    return nullptr;
}

/// What people call a device of the driver with these kinematics; empty: it goes by its model.
inline std::string_view nameOf(const Driver& driver, std::string_view kinematics) noexcept {
    const KinematicsEntry* entry = kinematicsOf(driver, kinematics);
    return entry && !entry->name.empty() ? entry->name : driver.name;
}

/// KinematicsEntry::make of a class with a create(descriptor).
template <class Kinematics>
core::Result<std::unique_ptr<IToolKinematics>> makeKinematicsOf(const DeviceDescriptor& descriptor) {
    auto made = Kinematics::create(descriptor);
    if (!made)
        return tl::unexpected(made.error());
    return std::make_unique<Kinematics>(*made);
}

} // namespace chiron::devices
