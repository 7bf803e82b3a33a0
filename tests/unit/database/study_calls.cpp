// SPDX-License-Identifier: GPL-3.0-or-later
#include "access_calls.h"
#include "study_site.h"

#include "database/query.h"

namespace chiron::test {

using namespace database;

namespace {

using Calls = std::map<Action, Call>;
using C = Connection;
using A = const Actor&;
using N = std::int64_t;

// The sealed code of "soft" in this participant's study, as a blind experimenter has it from the list.
std::string codeFor(C& c, N participant) {
    const auto study = selectInteger(c, "SELECT study_id FROM study_participant WHERE id = ?", {participant});
    return study ? codeOf(c, study->value_or(0), "soft") : std::string();
}

void addWriting(Calls& map) {
    const auto add = [&](Action action, Touches touches, auto run) { map[action] = {touches, true, run}; };
    add(Action::createStudy, Touches::nothing,
        [](C& c, A a, N) { return drop(StudyRepository(c, a).createStudy("new_study", "New", "{}")); });
    add(Action::saveDraft, Touches::draft,
        [](C& c, A a, N n) { return StudyRepository(c, a).saveDraft(n, "{}"); });
    add(Action::freezeStudy, Touches::draft,
        [](C& c, A a, N n) { return drop(StudyRepository(c, a).freezeStudy(n)); });
    add(Action::closeStudy, Touches::frozen,
        [](C& c, A a, N n) { return StudyRepository(c, a).closeStudy(n); });
    add(Action::setStudyArchived, Touches::frozen,
        [](C& c, A a, N n) { return StudyRepository(c, a).setStudyArchived(n, true); });
    add(Action::unblindStudy, Touches::frozen,
        [](C& c, A a, N n) { return StudyRepository(c, a).unblindStudy(n, "all are done"); });
    add(Action::enrolParticipant, Touches::frozen,
        [](C& c, A a, N n) { return drop(StudyRepository(c, a).enrolParticipant(n, "", 0, "weber:0.2")); });
    add(Action::enrolAccount, Touches::frozen,
        [](C& c, A a, N n) { return drop(StudyRepository(c, a).enrolAccount(n, "", "bob")); });
    add(Action::recordConsent, Touches::enrolled,
        [](C& c, A a, N n) { return StudyRepository(c, a).recordConsent(n, consentDigest()); });
    add(Action::completeParticipant, Touches::ready,
        [](C& c, A a, N n) { return StudyRepository(c, a).completeParticipant(n); });
    add(Action::withdrawParticipant, Touches::participant,
        [](C& c, A a, N n) { return StudyRepository(c, a).withdrawParticipant(n, false); });
    add(Action::conductRun, Touches::ready,
        [](C& c, A a, N n) { return drop(StudyRepository(c, a).conductRun(n, codeFor(c, n))); });
    add(Action::beginRun, Touches::ready, [](C& c, A a, N n) {
        return drop(StudyRepository(c, a).beginRun({n, codeFor(c, n), 1, 3, "descending@1"}));
    });
    add(Action::sealedConditions, Touches::frozen,
        [](C& c, A a, N n) { return drop(StudyReader(c, a).sealedConditions(n)); });
    add(Action::storeStudyTrial, Touches::run,
        [](C& c, A a, N n) { return StudyRepository(c, a).storeStudyTrial(someTrial(n, 1)); });
    add(Action::finishRun, Touches::run,
        [](C& c, A a, N n) { return StudyRepository(c, a).finishRun(n, StudyRunState::stopped); });
    add(Action::storeQuestionnaireAnswers, Touches::ready, [](C& c, A a, N n) {
        return StudyRepository(c, a).storeQuestionnaireAnswers({{n, "face", "years", 12.0, "", ""}});
    });
    add(Action::participantKeys, Touches::keys,
        [](C& c, A a, N n) { return drop(StudyReader(c, a).participantKeys(n)); });
    add(Action::eraseParticipant, Touches::withdrawn,
        [](C& c, A a, N n) { return drop(PrivacyRepository(c, a).eraseParticipant(n, "wish")); });
}

void addReading(Calls& map) {
    const auto add = [&](Action action, Touches touches, auto run) { map[action] = {touches, false, run}; };
    add(Action::listStudies, Touches::nothing,
        [](C& c, A a, N) { return drop(StudyReader(c, a).listStudies(true)); });
    add(Action::listPilots, Touches::nothing,
        [](C& c, A a, N) { return drop(StudyReader(c, a).listPilots("simulated")); });
    add(Action::studyByKey, Touches::nothing,
        [](C& c, A a, N) { return drop(StudyReader(c, a).studyByKey("simulated")); });
    add(Action::study, Touches::frozen, [](C& c, A a, N n) { return drop(StudyReader(c, a).study(n)); });
    add(Action::conditionCodes, Touches::frozen,
        [](C& c, A a, N n) { return drop(StudyReader(c, a).conditionCodes(n)); });
    add(Action::participants, Touches::frozen,
        [](C& c, A a, N n) { return drop(StudyReader(c, a).participants(n)); });
    add(Action::participantByCode, Touches::frozen, [](C& c, A a, N n) {
        const auto code = selectText(c, "SELECT code FROM study_participant WHERE study_id = ?", {n});
        return code ? drop(StudyReader(c, a).participantByCode(n, code->value_or(""))) : drop(code);
    });
    add(Action::runs, Touches::participant, [](C& c, A a, N n) { return drop(StudyReader(c, a).runs(n)); });
    add(Action::trialQuality, Touches::frozen,
        [](C& c, A a, N n) { return drop(StudyReader(c, a).trialQuality(n)); });
    add(Action::studyTrials, Touches::run,
        [](C& c, A a, N n) { return drop(StudyReader(c, a).studyTrials(n)); });
    add(Action::questionnaireAnswers, Touches::frozen,
        [](C& c, A a, N n) { return drop(StudyReader(c, a).questionnaireAnswers(n)); });
}

} // namespace

Calls studyCalls() {
    Calls map;
    addWriting(map);
    addReading(map);
    return map;
}

} // namespace chiron::test
