// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/generated_password.h"

#include "database/accounts/account_rules.h"

#include <sodium.h>
#include <string_view>

namespace chiron::database {

std::string generatedPassword() {
    // 32 entries, five bits per letter.
    constexpr std::string_view kLetters = "abcdefghjkmnpqrstuvwxyz234567892";
    static_assert(kLetters.size() == 32);
    std::string value;
    do {
        value.clear();
        for (int i = 0; i < 16; ++i) {
            value.push_back(kLetters[randombytes_uniform(static_cast<std::uint32_t>(kLetters.size()))]);
        }
    } while (!checkPassword("", value)); // the rules require at least four different letters
    return value;
}

} // namespace chiron::database
