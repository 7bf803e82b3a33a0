// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace chiron::database {

/// 16 letters and digits from the system's generator (80 bits), without the ones that look alike: a password
/// that somebody reads out once and that must be changed at the next login.
std::string generatedPassword();

} // namespace chiron::database
