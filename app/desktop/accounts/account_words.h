// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"

#include <QString>

namespace chiron::desktop {

/// What a role is called, translated.
QString roleName(database::Role role);

/// Why somebody was not let in, kindly and without telling whether the name or the password was wrong. The wait is told by
/// the countdown (WaitCountdown).
QString refusalWords(const database::Refusal& refusal);
/// The same for the login screen, where the name may be one of yesterday.
QString loginRefusalWords(const database::Refusal& refusal);
/// Where the name is known to be right: only the password can be wrong.
QString wrongPasswordWords();
/// The same as refusalWords for a recovery code.
QString recoveryRefusalWords(const database::Refusal& refusal);

/// "Try again in 4 seconds".
QString waitWords(int seconds);

} // namespace chiron::desktop
