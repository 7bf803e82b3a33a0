// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/initial_password.h"

#include "database/accounts/generated_password.h"

namespace chiron::cli {

NewPassword newPasswordOrGenerated(const std::vector<std::string>& secrets) {
    if (secrets.size() > 1 && !secrets[1].empty())
        return {secrets[1], false};
    return {database::generatedPassword(), true};
}

} // namespace chiron::cli
