// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"

#include <QJsonObject>

namespace chiron::session {

/// The data that a session stores of its device, so that a replay creates the same kinematics and the same
/// caps again. Lossless: doubles are written in the shortest form that reads back to the same bits.
QJsonObject toJson(const devices::DeviceDescriptor& descriptor);
core::Result<devices::DeviceDescriptor> descriptorFromJson(const QJsonObject& json);

QJsonObject toJson(const devices::WorkspaceMapping& mapping);
core::Result<devices::WorkspaceMapping> mappingFromJson(const QJsonObject& json);

} // namespace chiron::session
