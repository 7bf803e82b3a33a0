// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/study_json.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "psychophysics/designs/latin_square.h"
#include "psychophysics/observers/simulated_observer.h"
#include "session/study/study_progress.h"
#include "support/desktop_fixture.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace chiron::tests {

/// A complete study of two conditions, small enough to be run in a test: rankings of stiffness and of mass,
/// two questionnaires' worth of questions in one.
inline psychophysics::StudyDesign smallStudy(const std::string& key, bool blind = false) {
    using namespace psychophysics;
    StudyDesign study;
    study.id = key;
    study.title = {{"en", "Feeling stiffness and mass"}, {"de", "Steifigkeit und Masse fühlen"}};
    study.objective = {
        {"en", "How small a difference in stiffness and in mass is felt with a laparoscopic instrument."}};
    study.instructions = {
        {"en", "Take hold of each object and pull it up. Then put the three in order, from least to most."}};
    study.consent = {{"en", "I take part of my own free will. I may stop at any time, without a reason and "
                            "without disadvantage. What I do is "
                            "recorded under a random code."}};
    for (const auto& [id, title, attribute, reference] :
         {std::tuple{"stiffness", "Stiffness of a tube", Attribute::stiffness, 300.0},
          std::tuple{"mass", "Mass of an object", Attribute::mass, 0.1}}) {
        Condition condition;
        condition.id = id;
        condition.title = {{"en", title}};
        condition.stimulus.attribute = attribute;
        condition.stimulus.reference = reference;
        for (int i = 0; i < 24; ++i)
            condition.stimulus.differences.push_back(0.008 * std::pow(30.0, i / 23.0));
        Rank3Spec procedure;
        procedure.differences = condition.stimulus.differences;
        for (int i = 0; i < 31; ++i)
            procedure.log10Sigma.push_back(-2.6 + 0.07 * i);
        procedure.stop.trials = 40;
        condition.procedures = {procedure};
        study.conditions.push_back(std::move(condition));
    }
    Questionnaire questions;
    questions.id = "validity";
    questions.title = {{"en", "Face and content validity"}};
    QuestionnaireItem real{"realism",
                           {{"en", "How real did the objects feel?"}},
                           QuestionnaireItem::Kind::likert,
                           5,
                           {{"en", "not at all"}},
                           {{"en", "completely"}},
                           {},
                           "face",
                           0,
                           0,
                           true};
    QuestionnaireItem years{"years",
                            {{"en", "Years of laparoscopic surgery"}},
                            QuestionnaireItem::Kind::number,
                            5,
                            {},
                            {},
                            {},
                            "",
                            0,
                            60,
                            true};
    QuestionnaireItem hand{"hand",
                           {{"en", "Which hand do you work with?"}},
                           QuestionnaireItem::Kind::choice,
                           5,
                           {},
                           {},
                           {{{"en", "left"}}, {{"en", "right"}}, {{"en", "both"}}},
                           "",
                           0,
                           0,
                           true};
    QuestionnaireItem words{
        "remarks", {{"en", "What would you change?"}}, QuestionnaireItem::Kind::text, 5, {}, {}, {}, "", 0, 0,
        false};
    questions.items = {real, years, hand, words};
    study.questionnaires = {questions};
    study.participantsPlanned = 6;
    study.blindExperimenter = blind;
    study.trial.practiceTrials = 0;
    study.seed = 20261122;
    return study;
}

/// So many marks on the apex of a sphere of 20 mm radius.
inline psychophysics::StudyDesign apexStudy(const std::string& key, int marks) {
    psychophysics::StudyDesign design = smallStudy(key);
    design.title = {{"en", "Finding the apex"}};
    psychophysics::Condition condition;
    condition.id = "sphere";
    condition.title = {{"en", "Sphere of 20 mm radius"}};
    condition.stimulus = {psychophysics::Attribute::apex, 0.02, {0.0}, {{"stiffness_N_per_m", 500.0}}};
    condition.task = psychophysics::Task::adjustment;
    condition.procedures = {psychophysics::ConstantSpec{{0.0}, marks, true}};
    design.conditions = {condition};
    design.questionnaires.clear();
    return design;
}

/// One write as somebody; ends the test program where it fails.
template <class Job> auto writeAs(DesktopFixture& desktop, const database::Actor& actor, Job job) {
    auto done = desktop.database().write([&](database::WriteContext& writing) {
        database::StudyRepository studies(writing.connection(), actor);
        return job(studies);
    });
    if (!done)
        qFatal("%s", done.error().message.c_str());
    return done;
}

inline database::StudyNumber addDraft(DesktopFixture& desktop, const database::Actor& actor,
                                      const psychophysics::StudyDesign& design) {
    return *writeAs(desktop, actor, [&](database::StudyRepository& studies) {
        return studies.createStudy(design.id, design.title.at("en"),
                                   catalogue::studyJson(design).toStdString());
    });
}

/// A participant who has consented.
inline database::Participant addParticipant(DesktopFixture& desktop, const database::Actor& actor,
                                            database::StudyNumber study,
                                            const psychophysics::StudyDesign& design,
                                            const std::string& identity) {
    const auto participant = *writeAs(desktop, actor, [&](database::StudyRepository& studies) {
        return studies.enrolParticipant(study, identity, 0, {});
    });
    const std::string consent = catalogue::studySha256(QByteArray::fromStdString(design.consent.at("en")));
    writeAs(desktop, actor, [&](database::StudyRepository& studies) {
        return studies.recordConsent(participant.id, consent);
    });
    return participant;
}

/// What a device would have said of a trial that went well.
inline constexpr const char* kGoodFidelity =
    R"({"contacts":5,"duration_s":7.3,"force_error_rms_N":0.03,"late_ticks":0.0004,"mean_speed_m_per_s":0.041,)"
    R"("measured":true,"outside":"","peak_force_N":1.9,"places":[],"saturated":0,"stiffness_error":0.031,"worst_lateness_us":180})";

/// What a condition goes by until its study is unblinded, where experimenters are blind. By the study's
/// author, who may look.
inline std::string labelOf(DesktopFixture& desktop, const database::Actor& author,
                           const psychophysics::StudyDesign& design, database::StudyNumber study,
                           const std::string& condition) {
    if (!design.blindExperimenter)
        return condition;
    const auto all = desktop.context.site().database().write([&](database::WriteContext& context) {
        return database::StudyReader(context.connection(), author).sealedConditions(study);
    });
    for (const database::SealedCondition& each : all.value_or(std::vector<database::SealedCondition>{}))
        if (each.condition == condition)
            return each.sealedCode;
    qFatal("no code of %s", condition.c_str());
}

/// A completed run of rankings, answered by a simulated observer without rendering. Every ninth presentation
/// is spoiled.
inline void addRun(DesktopFixture& desktop, const database::Actor& actor,
                   const psychophysics::StudyDesign& design, const database::Participant& participant,
                   const std::string& condition, double weber, std::uint64_t seed) {
    auto progress = session::StudyProgress::begin(design, condition, seed);
    if (!progress)
        qFatal("%s", progress.error().message.c_str());
    const auto of = std::find_if(design.conditions.begin(), design.conditions.end(),
                                 [&](const auto& each) { return each.id == condition; });
    const psychophysics::Task task = of->task;
    psychophysics::SimulatedObserver observer({.weber = weber, .lapse = 0.02, .ties = 0.6}, seed);
    const database::NewStudyRun asked{participant.id,
                                      labelOf(desktop, actor, design, participant.study, condition), 0, seed,
                                      progress->procedureIds()};
    const auto run =
        *writeAs(desktop, actor, [&](database::StudyRepository& studies) { return studies.beginRun(asked); });
    for (int ordinal = 0; !progress->done(); ++ordinal) {
        if (progress->breakDue())
            progress->breakTaken();
        std::vector<double> log10Values;
        for (const double value : progress->next().values)
            log10Values.push_back(std::log10(value));
        session::StudyAnswer answer;
        answer.answer = observer.answer(task, log10Values);
        answer.exploration_s = 6.5;
        answer.answer_s = 0.8;
        answer.spoiled = ordinal % 9 == 8 ? "experimenter" : "";
        auto trial = progress->record(answer);
        if (!trial)
            qFatal("%s", trial.error().message.c_str());
        trial->run = run;
        trial->fidelityJson = kGoodFidelity;
        writeAs(desktop, actor,
                [&](database::StudyRepository& studies) { return studies.storeStudyTrial(*trial); });
    }
    writeAs(desktop, actor, [&](database::StudyRepository& studies) {
        return studies.finishRun(run, database::StudyRunState::completed);
    });
}

inline void addAnswers(DesktopFixture& desktop, const database::Actor& actor,
                       const database::Participant& participant, int realism) {
    const auto answer = [&](const char* item, std::optional<double> number, const char* text) {
        database::QuestionnaireAnswer given;
        given.participant = participant.id;
        given.questionnaire = "validity";
        given.item = item;
        given.number = number;
        given.text = text;
        return given;
    };
    writeAs(desktop, actor, [&](database::StudyRepository& studies) {
        return studies.storeQuestionnaireAnswers(
            {answer("realism", realism, ""), answer("years", 4.0 + realism, ""), answer("hand", 1.0, ""),
             answer("remarks", std::nullopt, "The tube could be longer.")});
    });
}

/// Studies to look at, rhea's: a draft, one with data, one whose experimenter is blind.
struct VisitedStudies {
    database::StudyNumber draft = 0;
    database::StudyNumber data = 0;
    database::StudyNumber blind = 0;
    QString waiting; ///< of `data`: has consented and done nothing
};

inline VisitedStudies addVisitedStudies(DesktopFixture& desktop) {
    const database::Actor rhea = desktop.actor("rhea");
    VisitedStudies studies;
    studies.draft = addDraft(desktop, rhea, smallStudy("pilot"));
    const auto freeze = [&](database::StudyNumber study) {
        writeAs(desktop, rhea, [&](database::StudyRepository& all) { return all.freezeStudy(study); });
    };
    const psychophysics::StudyDesign design = smallStudy("jnd_stiffness_mass");
    studies.data = addDraft(desktop, rhea, design);
    freeze(studies.data);
    const double webers[] = {0.08, 0.11, 0.16};
    for (int i = 0; i < 3; ++i) {
        const auto participant =
            addParticipant(desktop, rhea, studies.data, design, "surgeon " + std::to_string(i + 1));
        addRun(desktop, rhea, design, participant, "stiffness", webers[i], static_cast<std::uint64_t>(7 + i));
        addRun(desktop, rhea, design, participant, "mass", 1.3 * webers[i],
               static_cast<std::uint64_t>(17 + i));
        addAnswers(desktop, rhea, participant, 3 + i % 3);
        writeAs(desktop, rhea,
                [&](database::StudyRepository& all) { return all.completeParticipant(participant.id); });
    }
    studies.waiting =
        QString::fromStdString(addParticipant(desktop, rhea, studies.data, design, "surgeon 4").code);
    const psychophysics::StudyDesign sealed = smallStudy("jnd_blind", true);
    studies.blind = addDraft(desktop, rhea, sealed);
    freeze(studies.blind);
    const auto participant = addParticipant(desktop, rhea, studies.blind, sealed, "resident 1");
    addRun(desktop, rhea, sealed, participant, "stiffness", 0.1, 31);
    return studies;
}

} // namespace chiron::tests
