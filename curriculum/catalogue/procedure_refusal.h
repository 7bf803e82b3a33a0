// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"
#include "core/result.h"

#include <QJsonObject>

namespace chiron::catalogue {

/// What a procedure refuses ("start: expected ..."), as a problem at the first of the keys it names that is there, or has a default.
/// `withDefaults`: the procedure with every key, as it was read.
void addRefusal(const core::Error& error, const ObjectReader& json, const QJsonObject& withDefaults);

} // namespace chiron::catalogue
