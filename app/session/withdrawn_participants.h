// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/study_reader.h"

#include <string>
#include <vector>

namespace chiron::session {

/// A participant who has withdrawn from a study and whose data are not erased yet.
struct WithdrawnParticipant {
    database::Participant participant;
    std::string studyTitle;
};

/// Withdrawn participants of all studies and their pilots, including archived ones; those who requested the
/// erasure of their recordings come first.
/// Errors: those of the reader.
core::Result<std::vector<WithdrawnParticipant>> withdrawnParticipants(database::StudyReader& reader);

} // namespace chiron::session
