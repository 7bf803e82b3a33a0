// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::session_report {

/// The name of the finger that tool `tool` is: "Right index finger"; "Finger" if there is only one.
QString fingerName(int tool, int hands, int fingers);

} // namespace chiron::session_report
