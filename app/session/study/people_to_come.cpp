// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/people_to_come.h"

#include <algorithm>

namespace chiron::session {

int peopleToCome(const psychophysics::StudyDesign& design, const database::StudySummary& study,
                 const std::vector<database::Participant>& participants) {
    using State = database::ParticipantState;
    int enrolled = 0, unfinished = 0;
    for (const database::Participant& each : participants) {
        if (each.simulated || each.state == State::withdrawn)
            continue;
        ++enrolled;
        unfinished += each.state == State::completed ? 0 : 1;
    }
    const bool open = study.state == database::StudyState::frozen;
    return unfinished + (open ? std::max(0, design.participantsPlanned - enrolled) : 0);
}

} // namespace chiron::session
