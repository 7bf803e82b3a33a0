// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/password_cost.h"

#include <string>

namespace chiron::database {

/// Hashes with Argon2id through libsodium (crypto_pwhash_str). It is slow on purpose: call it on a worker,
/// never in a writer job.
class PasswordHasher {
public:
    explicit PasswordHasher(PasswordCost cost) : m_cost(cost) {}
    /// Errors: storage if there is not enough memory.
    core::Result<std::string> hash(const std::string& secret) const;
    /// Compares with a stored hash in constant time, at the cost written in that hash.
    bool verify(const std::string& storedHash, const std::string& secret) const;

private:
    PasswordCost m_cost;
};

} // namespace chiron::database
