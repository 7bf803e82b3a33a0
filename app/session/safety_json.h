// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "haptics/safety_settings.h"

#include <QJsonObject>

namespace chiron::session {

/// The supervisor's settings as stored with each session; a replay uses the stored ones.
QJsonObject toJson(const haptics::SafetySettings& settings);
core::Result<haptics::SafetySettings> safetyFromJson(const QJsonObject& json);

} // namespace chiron::session
