// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"

#include <QString>

namespace chiron::desktop {

/// The translated name of a role.
QString roleName(database::Role role);

/// Explains politely why a person was not let in, without revealing whether the name or the password was
/// wrong. The text does not give the waiting time; WaitCountdown shows it.
QString refusalWords(const database::Refusal& refusal);
/// The same for the login screen. It also mentions that the login name may have changed.
QString loginRefusalWords(const database::Refusal& refusal);
/// For places where the name is known to be right, so that only the password can be wrong.
QString wrongPasswordWords();
/// The same as refusalWords(), but for a recovery code.
QString recoveryRefusalWords(const database::Refusal& refusal);

/// "Try again in 4 seconds".
QString waitWords(int seconds);

} // namespace chiron::desktop
