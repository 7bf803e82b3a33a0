// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/privacy_repository.h"

#include <vector>

namespace chiron::database {

/// Returns the study data of a person with an account. The caller checks the rights beforehand. `own`: the
/// person, who conducts no studies, asks for their own data. In a blinded study that they have completed or
/// left, their trials are then included, by runs without sealed codes: the blinding is for those who conduct
/// the study, and people have a right to the data about themselves.
/// Errors: storage.
core::Result<std::vector<PersonParticipation>> participationsOf(Connection& connection, PersonId person,
                                                                bool own);

} // namespace chiron::database
