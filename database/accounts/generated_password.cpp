// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/generated_password.h"

#include "database/accounts/account_rules.h"

#include <cstdint>
#include <sodium.h>
#include <string_view>

namespace chiron::database {

namespace {

constexpr std::string_view kLetters = "abcdefghjkmnpqrstuvwxyz23456789"; // without i, l, o, 0 and 1

constexpr bool allDiffer(std::string_view letters) {
    for (std::size_t i = 0; i < letters.size(); ++i)
        if (letters.find(letters[i], i + 1) != std::string_view::npos)
            return false;
    return true;
}
static_assert(kLetters.size() == 31 && allDiffer(kLetters)); // 16 of them: 79 bits

} // namespace

std::string generatedPassword() {
    std::string value;
    do {
        value.clear();
        for (int i = 0; i < 16; ++i)
            value.push_back(kLetters[randombytes_uniform(static_cast<std::uint32_t>(kLetters.size()))]);
    } while (!checkPassword("", value)); // the rules require at least four different letters
    return value;
}

} // namespace chiron::database
