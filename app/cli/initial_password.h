// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace chiron::cli {

struct NewPassword {
    std::string value;
    bool generated = false; ///< if so, it is shown once and must be changed at the first login
};

/// Returns the second secret. If there is none, returns 16 letters and digits from the system's random number
/// generator (79 bits), without characters that look alike.
NewPassword newPasswordOrGenerated(const std::vector<std::string>& secrets);

} // namespace chiron::cli
