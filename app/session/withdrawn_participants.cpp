// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/withdrawn_participants.h"

#include <algorithm>

namespace chiron::session {

core::Result<std::vector<WithdrawnParticipant>> withdrawnParticipants(database::StudyReader& reader) {
    auto studies = reader.listStudies(true);
    CHIRON_TRY(studies);
    for (std::size_t i = 0, own = studies->size(); i < own; ++i) {
        const auto pilots = reader.listPilots((*studies)[i].key);
        CHIRON_TRY(pilots);
        studies->insert(studies->end(), pilots->begin(), pilots->end());
    }
    std::vector<WithdrawnParticipant> withdrawn;
    for (const database::StudySummary& study : *studies) {
        const auto participants = reader.participants(study.id);
        CHIRON_TRY(participants);
        for (const database::Participant& each : *participants)
            if (each.state == database::ParticipantState::withdrawn && !each.erased && !each.simulated)
                withdrawn.push_back({each, study.title});
    }
    std::stable_partition(withdrawn.begin(), withdrawn.end(), [](const WithdrawnParticipant& each) {
        return each.participant.recordingsToErase;
    });
    return withdrawn;
}

} // namespace chiron::session
