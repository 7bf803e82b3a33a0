// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace chiron::database {

/// Returns 5 groups of 5 symbols, from 32 symbols that do not look alike: 125 bits.
std::string newRecoveryCode();

} // namespace chiron::database
