// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/canonical_json.h"
#include "database/query.h"
#include "database/repositories/privacy_repository.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "database_fixture.h"

#include <string>

namespace chiron::test {

inline constexpr const char* kConsent = "I agree to take part.";

/// A small study of two conditions and a questionnaire with a question of each kind.
inline std::string someDesign(const std::string& key) {
    const auto condition = [](const std::string& id, int reference) {
        return R"({"id":")" + id + R"(","title":{"en":")" + id + R"("},"instructions":{"en":"Take the )" +
               id + R"( one."},"stimulus":{"attribute":"stiffness","reference":)" +
               std::to_string(reference) +
               R"(,"differences":[0.02,0.05,0.1]},"task":"rank3","procedures":[{"kind":"descending","levels":[0.1,0.05,0.02]}]})";
    };
    return R"({"id":")" + key + R"(","title":{"en":"Stiffness of )" + key +
           R"("},"objective":{"en":"What is told apart."},"instructions":{"en":"Order the three."},"consent":{"en":")" +
           kConsent + R"(","de":"Ich nehme teil."},"conditions":[)" + condition("soft", 200) + "," +
           condition("hard", 800) +
           R"(],"questionnaires":[{"id":"face","title":{"en":"Face"},"items":[)"
           R"({"id":"real","text":{"en":"It felt real"},"kind":"likert","scale":5},)"
           R"({"id":"years","text":{"en":"Years"},"kind":"number","lowest":0,"highest":60},)"
           R"({"id":"hand","text":{"en":"Hand"},"kind":"choice","choices":[{"en":"left"},{"en":"right"}]},)"
           R"({"id":"remarks","text":{"en":"Remarks"},"kind":"text"}]}],"blind_experimenter":true,"seed":7})";
}

inline std::string consentDigest() {
    return catalogue::sha256Hex(kConsent);
}

inline database::StudyTrial someTrial(database::StudyRunNumber run, int ordinal,
                                      database::SessionId session = 0) {
    database::StudyTrial trial;
    trial.run = run;
    trial.ordinal = ordinal;
    trial.session = session;
    trial.firstTick = static_cast<std::uint64_t>(ordinal) * 1000;
    trial.lastTick = trial.firstTick + 999;
    trial.candidate = 2;
    trial.arrangement = ordinal % 6;
    trial.difference = 0.1;
    trial.entropyMargin = ordinal == 0 ? 0.25 : trial.entropyMargin;
    trial.answer = 3;
    trial.outcome = ordinal % 6;
    trial.exploration_s = 4.5;
    trial.answer_s = 0.75;
    trial.practice = ordinal == 0;
    trial.spoiled = ordinal == 1 ? "late_ticks" : "";
    trial.fidelityJson = R"({"contacts":3})";
    return trial;
}

/// What a condition goes by while the study is blinded, whoever may know it; empty: there is none.
inline std::string codeOf(database::Connection& connection, database::StudyNumber study,
                          const std::string& condition) {
    const auto code = database::selectText(
        connection, "SELECT sealed_code FROM study_condition WHERE study_id = ? AND condition = ?",
        {study, condition});
    return code ? code->value_or("") : std::string();
}

/// A study with somebody in each state, of one author. Participants of the simulated account are simulated.
struct StudyTargets {
    database::StudyNumber draft = 0, frozen = 0;
    database::ParticipantNumber enrolled = 0, ready = 0, running = 0, withdrawn = 0;
    database::StudyRunNumber run = 0;
};

inline core::Result<database::ParticipantNumber> enrol(database::StudyRepository& studies,
                                                       const database::Actor& actor,
                                                       database::StudyNumber study, bool consent) {
    const bool simulated = actor.kind() == database::ActorKind::simulated;
    const auto made =
        studies.enrolParticipant(study, simulated ? "" : "Jane Roe, ward 3", 0, simulated ? "weber:0.1" : "");
    CHIRON_TRY(made);
    const auto agreed = consent ? studies.recordConsent(made->id, consentDigest()) : core::Result<void>();
    return agreed ? core::Result<database::ParticipantNumber>(made->id) : tl::unexpected(agreed.error());
}

inline core::Result<StudyTargets> makeStudies(database::Database& site, const database::Actor& actor,
                                              const std::string& name) {
    using namespace database;
    return site.write([&](WriteContext& w) -> core::Result<StudyTargets> {
        StudyRepository studies(w.connection(), actor);
        StudyTargets made;
        const auto draft = studies.createStudy(name + "_draft", "Draft", someDesign(name + "_draft"));
        const auto frozen = studies.createStudy(name, "Stiffness", someDesign(name));
        if (!draft || !frozen) {
            return tl::unexpected(!draft ? draft.error() : frozen.error());
        }
        made.draft = *draft;
        made.frozen = *frozen;
        CHIRON_TRY(studies.freezeStudy(*frozen));
        for (auto [target, consent] : {std::pair{&made.enrolled, false},
                                       {&made.ready, true},
                                       {&made.running, true},
                                       {&made.withdrawn, true}}) {
            const auto who = enrol(studies, actor, *frozen, consent);
            CHIRON_TRY(who);
            *target = *who;
        }
        const auto run = studies.beginRun({made.running, codeOf(w.connection(), *frozen, "hard"), 0,
                                           0xfedcba9876543210ULL, "descending@1"});
        auto done = run ? studies.storeStudyTrial(someTrial(*run, 0)) : tl::unexpected(run.error());
        done = done ? studies.withdrawParticipant(made.withdrawn, true) : done;
        CHIRON_TRY(done);
        made.run = *run;
        return made;
    });
}

} // namespace chiron::test
