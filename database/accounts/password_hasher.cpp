// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/password_hasher.h"

#include <array>
#include <sodium.h>

namespace chiron::database {

core::Result<std::string> PasswordHasher::hash(const std::string& secret) const {
    std::array<char, crypto_pwhash_STRBYTES> text{};
    if (sodium_init() < 0 || crypto_pwhash_str_alg(text.data(), secret.data(), secret.size(), m_cost.passes,
                                                   m_cost.memory_bytes, crypto_pwhash_ALG_ARGON2ID13) != 0) {
        return core::fail(core::ErrorCode::storage, "not enough memory to protect the password (" +
                                                        std::to_string(m_cost.memory_bytes >> 20) +
                                                        " MiB needed)");
    }
    return std::string(text.data());
}

bool PasswordHasher::verify(const std::string& storedHash, const std::string& secret) const {
    return sodium_init() >= 0 && storedHash.size() < crypto_pwhash_STRBYTES &&
           crypto_pwhash_str_verify(storedHash.c_str(), secret.data(), secret.size()) == 0;
}

} // namespace chiron::database
