// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "psychophysics/study/study_design.h"

#include <vector>

namespace chiron::session {

/// The number of people who will still do runs of a study: participants who have not completed it and, while
/// it is open for enrolment, planned participants who are not enrolled yet. After unblinding, whoever
/// conducts their runs is no longer blind. Simulated participants do not count.
int peopleToCome(const psychophysics::StudyDesign& design, const database::StudySummary& study,
                 const std::vector<database::Participant>& participants);

} // namespace chiron::session
