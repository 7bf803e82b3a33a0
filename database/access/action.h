// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/access/repository_functions.h"

#include <string_view>

namespace chiron::database {

/// The actions that can be authorised: one for each public repository function, with the same name.
enum class Action {
#define CHIRON_ACTION(class_, function) function,
    CHIRON_REPOSITORY_FUNCTIONS(CHIRON_ACTION)
#undef CHIRON_ACTION
        count
};

/// Returns the function's name, for messages and the audit.
std::string_view token(Action action) noexcept;

} // namespace chiron::database
