// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace chiron::database {

/// 5 groups of 5 symbols of 32 without look-alikes: 125 bits.
std::string newRecoveryCode();

} // namespace chiron::database
