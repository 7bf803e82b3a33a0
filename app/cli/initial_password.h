// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace chiron::cli {

struct NewPassword {
    std::string value;
    bool generated = false; ///< shown once, to be changed at the first login
};

/// The second secret, or where there is none 16 letters and digits from the system's generator (80 bits),
/// without the ones that look alike.
NewPassword newPasswordOrGenerated(const std::vector<std::string>& secrets);

} // namespace chiron::cli
