// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/recovery_code.h"

#include <sodium.h>

namespace chiron::database {

std::string newRecoveryCode() {
    static constexpr char kSymbols[] = "ABCDEFGHJKLMNPQRSTUVWXYZ23456789";
    std::string code;
    for (int i = 0; i < 25; ++i) {
        code += i > 0 && i % 5 == 0 ? "-" : "";
        code.push_back(kSymbols[randombytes_uniform(32)]);
    }
    return code;
}

} // namespace chiron::database
