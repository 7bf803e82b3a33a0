// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/privacy_repository.h"

#include <vector>

namespace chiron::database {

/// What the studies hold of a person with an account; who may ask is checked before. `own`: the person asks, who conducts no studies; of a blinded one
/// that they have done or left their trials are handed out all the same, by runs without sealed codes: blind are those who conduct, and what is held
/// about somebody is theirs. Failure: storage.
core::Result<std::vector<PersonParticipation>> participationsOf(Connection& connection, PersonId person, bool own);

} // namespace chiron::database
