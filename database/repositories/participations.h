// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/privacy_repository.h"

#include <vector>

namespace chiron::database {

/// What the studies hold of a person with an account; who may ask is checked before. Failure: storage.
core::Result<std::vector<PersonParticipation>> participationsOf(Connection& connection, PersonId person);

} // namespace chiron::database
