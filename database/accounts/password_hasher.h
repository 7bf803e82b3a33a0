// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/password_cost.h"

#include <string>

namespace chiron::database {

/// Argon2id through libsodium (crypto_pwhash_str). Slow on purpose: call it on a worker, never in a writer
/// job.
class PasswordHasher {
public:
    explicit PasswordHasher(PasswordCost cost) : m_cost(cost) {}
    /// Failure: storage when the memory is not there.
    core::Result<std::string> hash(const std::string& secret) const;
    /// Constant-time comparison with a stored hash, at the cost written in it.
    bool verify(const std::string& storedHash, const std::string& secret) const;

private:
    PasswordCost m_cost;
};

} // namespace chiron::database
