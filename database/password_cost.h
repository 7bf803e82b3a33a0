// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace chiron::database {

/// Cost of one Argon2id hash (libsodium crypto_pwhash). The production cost is fixed (architecture.md,
/// Dependencies). The minimal cost exists for tests: it can be chosen only in code, not by any option or
/// file.
struct PasswordCost {
    unsigned long long passes = 3;        ///< t
    std::size_t memory_bytes = 64u << 20; ///< 64 MiB
    static PasswordCost production() { return {}; }
    static PasswordCost minimalForTests() { return {1, 8192}; } ///< crypto_pwhash_OPSLIMIT_MIN, MEMLIMIT_MIN
};

} // namespace chiron::database
