// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace chiron::database {

/// Returns 16 letters and digits from the system's random generator (79 bits), without symbols that look
/// alike. The password is read out once and must be changed at the next login.
std::string generatedPassword();

} // namespace chiron::database
