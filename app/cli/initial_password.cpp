// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/initial_password.h"

#include <QRandomGenerator>
#include <string_view>

namespace chiron::cli {

NewPassword newPasswordOrGenerated(const std::vector<std::string>& secrets) {
    if (secrets.size() > 1 && !secrets[1].empty())
        return {secrets[1], false};
    constexpr std::string_view kLetters = "abcdefghjkmnpqrstuvwxyz234567892"; // 32 places: five bits a letter
    static_assert(kLetters.size() == 32);
    std::string value;
    for (int i = 0; i < 16; ++i)
        value += kLetters[QRandomGenerator::system()->bounded(static_cast<quint32>(kLetters.size()))];
    return {value, true};
}

} // namespace chiron::cli
