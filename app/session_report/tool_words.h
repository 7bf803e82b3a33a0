// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::session_report {

/// "Right instrument" (tool 0), "Left instrument" (tool 1), "Instrument 3"; if there is only one:
/// "Instrument". In the program's language; screens and paper use the same words. Pure function.
QString instrumentName(int tool, int tools);

} // namespace chiron::session_report
