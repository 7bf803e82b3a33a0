// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/pilot_run.h"

#include "catalogue/language_words.h"
#include "catalogue/study_json.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"

namespace chiron::session {

namespace {

constexpr std::size_t kLongestKey = 64;

/// "tubes_pilot_2": the first key that is free.
core::Result<std::string> freeKey(database::StudyReader& reader, const std::string& study) {
    const auto pilots = reader.listPilots(study);
    CHIRON_TRY(pilots);
    for (std::size_t n = pilots->size() + 1;; ++n) {
        const std::string end = "_pilot_" + std::to_string(n);
        const std::string key = study.substr(0, kLongestKey - end.size()) + end;
        const auto taken = reader.studyByKey(key);
        if (!taken && taken.error().code == core::ErrorCode::notFound)
            return key;
        CHIRON_TRY(taken);
    }
}

const std::string& consentIn(const psychophysics::StudyDesign& design, const std::string& language) {
    const auto found = design.consent.find(language);
    return found != design.consent.end() ? found->second : design.consent.at("en");
}

core::Result<PilotRun> beginPilotRun(database::Connection& connection, const database::Actor& actor,
                                     const psychophysics::StudyDesign& draft, const std::string& who,
                                     const std::string& language) {
    database::StudyReader reader(connection, actor);
    database::StudyRepository studies(connection, actor);
    const auto key = freeKey(reader, draft.id);
    CHIRON_TRY(key);
    const psychophysics::StudyDesign design = pilotDesign(draft, *key);
    const auto study =
        studies.createStudy(*key, design.title.at("en"), catalogue::studyJson(design).toStdString());
    CHIRON_TRY(study);
    CHIRON_TRY(studies.freezeStudy(*study));
    const auto participant = studies.enrolParticipant(*study, who, 0, {});
    CHIRON_TRY(participant);
    CHIRON_TRY(studies.recordConsent(
        participant->id, catalogue::studySha256(QByteArray::fromStdString(consentIn(design, language)))));
    return PilotRun{*study, participant->code};
}

} // namespace

psychophysics::StudyDesign pilotDesign(const psychophysics::StudyDesign& draft, const std::string& key) {
    psychophysics::StudyDesign pilot = draft;
    pilot.id = key;
    pilot.pilotOf = draft.id;
    pilot.blindExperimenter = false;
    for (auto& [language, title] : pilot.title)
        title.insert(0, catalogue::wordsOfLanguage(language).pilotPrefix);
    return pilot;
}

core::Result<PilotRun> beginPilot(database::Database& database, const database::Actor& actor,
                                  const psychophysics::StudyDesign& draft, const std::string& who,
                                  const std::string& language) {
    // Errors of the draft are reported for the draft, not for its copy.
    CHIRON_TRY(catalogue::readStudy(catalogue::studyJson(draft), draft.id));
    return database.write([&](database::WriteContext& writing) {
        return beginPilotRun(writing.connection(), actor, draft, who, language);
    });
}

} // namespace chiron::session
