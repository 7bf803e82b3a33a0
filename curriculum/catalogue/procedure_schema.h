// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace chiron::catalogue {

/// content/schema/procedure.json, made of the rows of all kinds of procedures: what each key means, its unit, range and default. A key that
/// several kinds know takes what any of them takes.
QByteArray procedureSchema();

} // namespace chiron::catalogue
