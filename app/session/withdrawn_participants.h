// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/study_reader.h"

#include <string>
#include <vector>

namespace chiron::session {

/// A participant who has left a study and is not erased yet.
struct WithdrawnParticipant {
    database::Participant participant;
    std::string studyTitle;
};

/// Of every study and its pilots, archived ones too; those who asked for their recordings to be erased come first. Failure: the reader's.
core::Result<std::vector<WithdrawnParticipant>> withdrawnParticipants(database::StudyReader& reader);

} // namespace chiron::session
