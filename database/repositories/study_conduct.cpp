// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/audit/audit_trail.h"
#include "database/query.h"
#include "database/repositories/study_blinding.h"
#include "database/repositories/study_repository.h"
#include "database/repositories/study_rows.h"
#include "database/repositories/study_rules.h"

#include <algorithm>

// Blind experimenters can reach a condition of a blinded study only by conducting a run of it.
namespace chiron::database {

core::Result<void> mayRun(const StoredParticipant& who) {
    const bool may = who.state == ParticipantState::consented ||
                     (who.simulated && who.state == ParticipantState::enrolled);
    if (may) {
        return {};
    }
    return core::fail(core::ErrorCode::wrongUse, "participant " + who.code + " is " +
                                                     std::string(token(who.state)) +
                                                     (who.state == ParticipantState::enrolled
                                                          ? ": the consent must be recorded before a run"
                                                          : ": expected one who still takes part"));
}

core::Result<SealedCondition> namedCondition(Connection& connection, const StoredStudy& study,
                                             const std::string& name) {
    const auto blinding = blindingOf(connection, StudyPart::study, study.id);
    CHIRON_TRY(blinding);
    const auto all = sealedConditionRows(connection, study.id);
    CHIRON_TRY(all);
    const auto found = std::find_if(all->begin(), all->end(), [&](const SealedCondition& each) {
        return each.sealedCode == name || (!blinding->on && each.condition == name);
    });
    if (found != all->end()) {
        return *found;
    }
    return core::fail(core::ErrorCode::badInput,
                      "condition \"" + name + "\": expected " +
                          (blinding->on ? "the sealed code of one of study " : "one of study ") + study.key);
}

core::Result<ConductedRun> StudyRepository::conductRun(ParticipantNumber participant,
                                                       const std::string& condition) {
    auto good = mayWriteStudy(m_connection, m_actor, Action::conductRun, StudyPart::participant, participant);
    CHIRON_TRY(good);
    const auto who = storedParticipant(m_connection, participant);
    CHIRON_TRY(who);
    const auto study = storedStudy(m_connection, who->study);
    CHIRON_TRY(study);
    const auto named = namedCondition(m_connection, *study, condition);
    CHIRON_TRY(named);
    const auto blinding = blindingOf(m_connection, StudyPart::study, study->id);
    CHIRON_TRY(blinding);
    auto runs = runRows(m_connection, participant);
    CHIRON_TRY(runs);
    good = mayRun(*who);
    CHIRON_TRY(good);
    ConductedRun conducted{named->condition, named->sealedCode, {}, {}, study->designJson};
    for (StudyRun& run : *runs) {
        if (run.condition != named->condition || run.state == StudyRunState::stopped) {
            continue;
        }
        if (run.state == StudyRunState::completed) {
            return core::fail(core::ErrorCode::wrongUse, "condition " + condition + " is completed");
        }
        auto trials = studyTrialRows(m_connection, run.id);
        CHIRON_TRY(trials);
        conducted.open = std::move(run);
        conducted.trials = std::move(*trials);
    }
    if (!conducted.open && study->state != "frozen") {
        return core::fail(core::ErrorCode::wrongUse,
                          "study " + study->key + " is " + study->state + ": no run is begun any more");
    }
    if (blinding->on) {
        good = appendAudit(m_connection, m_actor,
                           {"conductRun", "study_participant", participant, std::nullopt,
                            "{\"sealed_code\":\"" + named->sealedCode + "\"}"});
    }
    CHIRON_TRY(good);
    return conducted;
}

} // namespace chiron::database
