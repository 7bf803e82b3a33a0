// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "psychophysics/study/study_design.h"

#include <vector>

namespace chiron::session {

/// How many people will still do runs of a study: those who take part and have not completed it, and while it takes participants those who are
/// planned and not enrolled yet. Whoever conducts their runs is no longer blind once it is unblinded. Simulated participants do not count.
int peopleToCome(const psychophysics::StudyDesign& design, const database::StudySummary& study, const std::vector<database::Participant>& participants);

} // namespace chiron::session
