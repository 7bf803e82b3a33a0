// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/generated_password.h"

#include "database/accounts/account_rules.h"

#include <sodium.h>
#include <string_view>

namespace chiron::database {

std::string generatedPassword() {
    constexpr std::string_view kLetters = "abcdefghjkmnpqrstuvwxyz234567892"; // 32 places: five bits a letter
    static_assert(kLetters.size() == 32);
    std::string value;
    do {
        value.clear();
        for (int i = 0; i < 16; ++i) {
            value.push_back(kLetters[randombytes_uniform(static_cast<std::uint32_t>(kLetters.size()))]);
        }
    } while (!checkPassword("", value)); // four different letters at least, as the rules want
    return value;
}

} // namespace chiron::database
