// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace chiron::catalogue {

/// Returns content/schema/procedure.json, generated from the parameter rows of all kinds of procedures: the
/// meaning, unit, range and default of each key. A key that several kinds share accepts the union of their
/// ranges.
QByteArray procedureSchema();

} // namespace chiron::catalogue
