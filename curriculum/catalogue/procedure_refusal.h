// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"
#include "core/result.h"

#include <QJsonObject>

namespace chiron::catalogue {

/// Adds the error with which a procedure refuses its parameters ("start: expected ...") as a problem, at the
/// first key named in the message that is present in `json` or has a default. `withDefaults` is the procedure
/// with every key, as it was read.
void addRefusal(const core::Error& error, const ObjectReader& json, const QJsonObject& withDefaults);

} // namespace chiron::catalogue
