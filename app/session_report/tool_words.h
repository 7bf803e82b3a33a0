// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::session_report {

/// "Right instrument" (tool 0), "Left instrument" (tool 1), "Instrument 3"; of one alone: "Instrument". Pure, as all of these, in the
/// program's language: the one source for screens and paper.
QString instrumentName(int tool, int tools);

} // namespace chiron::session_report
