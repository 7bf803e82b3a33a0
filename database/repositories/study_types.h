// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/actor.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace chiron::database {

using StudyNumber = std::int64_t;
using ParticipantNumber = std::int64_t;
using StudyRunNumber = std::int64_t;

enum class StudyState : std::uint8_t { draft, frozen, closed, archived };
enum class ParticipantState : std::uint8_t { enrolled, consented, completed, withdrawn };
enum class StudyRunState : std::uint8_t { open, completed, stopped };

/// A line of the list of studies.
struct StudySummary {
    StudyNumber id = 0;
    std::string key;   ///< the design's id
    std::string title; ///< English
    StudyState state = StudyState::draft;
    std::string sha256; ///< of the frozen design's canonical JSON, 64 hex digits; empty while a draft
    PersonId author = 0;
    std::string createdUtc;
    std::string frozenUtc;
    bool unblinded = false;
    bool demonstration = false;
    int participants = 0;
    int completed = 0; ///< participants
    int trials = 0;    ///< scored; while experimenters are blind of those who completed alone
    std::string pilotOf; ///< key of the study whose draft was tried with this copy; empty: no pilot
};

/// What a blinded study's lists leave out (study_blinding.h).
struct Blinding {
    bool designed = false; ///< the design blinds experimenters
    bool on = false;       ///< and the study is not unblinded
    // What all conditions have in common, and what therefore says nothing of a run.
    bool oneTask = true;
    bool oneTable = true;     ///< of differences
    bool oneProcedure = true; ///< procedures, their scale and criterion
    bool oneStimulus = true;  ///< attribute, reference and what the objects otherwise are
    bool adjusts = false;     ///< a condition's answers are values in SI (those of an apex are told as shares of its radius)
    bool oneExercise = true;  ///< all of an apex, or none

    /// Whether conditions are alike in all that the program does. Where they are not, whatever a run left behind (answers, times, speeds, how
    /// many trials) could tell which condition it is of, and none of it is shown before unblinding.
    bool analysable() const { return asksAlike() && oneStimulus; }
    /// Whether they ask alike, whatever the objects are; what is set in SI is of the objects, too.
    bool asksAlike() const { return oneTask && oneTable && oneProcedure && (oneStimulus || !adjusts); }
    /// Whether trials and what is estimated from them are kept back.
    bool seals() const { return on && !analysable(); }
};

struct StudyRecord {
    StudySummary summary;
    /// Canonical; catalogue::readStudy makes a psychophysics::StudyDesign of it. Masked: its conditions go by their sealed codes, and what they
    /// differ in has a neutral value that says nothing (study_mask.h).
    std::string designJson;
    Blinding blinding;   ///< of the design as it is
    bool masked = false; ///< for those who may not look up which code is which, of a frozen study while it is blinded
};

/// A participant as exports and experimenters know one: never a name.
struct Participant {
    ParticipantNumber id = 0;
    StudyNumber study = 0;
    std::string code; ///< random, e.g. "K7M-4QX"
    int order = 0;    ///< from 0: row of the order design
    ParticipantState state = ParticipantState::enrolled;
    bool simulated = false;
    std::string observer; ///< of a simulated one: its specification
    std::string enrolledUtc;
    std::string consentUtc; ///< empty: none
    std::string consentSha256; ///< of the text that was agreed to
    PersonId enrolledBy = 0;
    bool recordingsToErase = false; ///< of a withdrawn one: wants the recordings erased, too (an administrator does it)
    bool erased = false;            ///< key, free texts and questionnaires (and recordings, where wanted) are overwritten
};

/// Who a code is; kept apart, for administrators and the study's author alone.
struct ParticipantKey {
    ParticipantNumber participant = 0;
    std::string code;
    std::string identity;           ///< free text, as the researcher wrote it
    std::optional<PersonId> person; ///< where it is somebody with an account
    std::string account{};          ///< their login name
};

/// One condition done by one participant; goes on over several sittings (sessions).
struct StudyRun {
    StudyRunNumber id = 0;
    ParticipantNumber participant = 0;
    std::string condition;   ///< id in the design; empty while the study is blinded
    std::string sealedCode;  ///< what stands for it then
    int position = 0;        ///< from 0, in the participant's order
    std::uint64_t seed = 0;
    std::string procedures;  ///< ids with version, "rank3_quest_plus@1", comma-separated
    StudyRunState state = StudyRunState::open;
    std::string startedUtc;
    std::string endedUtc;
};

/// What a run begins with.
struct NewStudyRun {
    ParticipantNumber participant = 0;
    std::string condition; ///< id in the design; while the study is blinded its sealed code
    int position = 0;      ///< from 0, in the participant's order
    std::uint64_t seed = 0;
    std::string procedures; ///< as StudyRun::procedures
};

/// What a condition is called towards a blind experimenter: "Q7M", made with the site's key when the study is frozen, so that it can
/// neither be guessed nor computed from the design.
struct SealedCondition {
    std::string condition;
    std::string sealedCode;
};

/// One presentation, scored or not. Its digest covers all of it; never changed or deleted. Read while the study is blinded, it lacks what
/// would tell conditions apart (study_blinding.h).
struct StudyTrial {
    StudyRunNumber run = 0;
    int ordinal = 0;            ///< from 0, every presentation of the run counted
    int procedure = 0;          ///< which of interleaved ones
    SessionId session = 0;      ///< whose recording holds it; 0: none (a quick simulation)
    std::uint64_t firstTick = 0, lastTick = 0;
    int candidate = 0;          ///< row of the table of differences
    int arrangement = 0;
    double difference = 0.0;    ///< D asked for, log10 of the ratio
    double entropyMargin = std::numeric_limits<double>::quiet_NaN(); ///< absent where NaN
    int answer = -1;            ///< -1: none
    int outcome = -1;           ///< what the procedure was told; -1: nothing
    std::optional<double> value; ///< a number said (magnitude), or the value set (adjustment), SI
    double exploration_s = 0.0; ///< until the answer
    double answer_s = 0.0;      ///< from the last contact to the answer
    bool practice = false;
    bool undone = false;        ///< always false when stored; an undo is a row of its own that names it
    std::string spoiled;        ///< empty: scored; else why not: "force_error", "late_ticks", "saturation", "speed", "time", "experimenter", "stopped", ...
    std::string fidelityJson = "{}"; ///< canonical; session::TrialFidelity
    std::string utc;
    // Read with it, of the session that holds it; not stored with a trial.
    std::string device;         ///< model of its first device; empty without a session
    std::optional<bool> felt;   ///< whether force was rendered, or only shown; nothing without a session
};

/// How well a participant's trials went, over all conditions together, so that it can be watched while a study is blinded. What depends on the
/// objects (how often trials were repeated, how long they took) is told once every condition is completed: then it is of none in particular.
struct ParticipantQuality {
    ParticipantNumber participant = 0;
    int conditionsDone = 0;     ///< completed runs
    int conditions = 0;         ///< of the study
    bool whole = false;         ///< every condition is completed, or the study is not blinded: what follows below `device` is told
    double lateTicks = std::numeric_limits<double>::quiet_NaN();        ///< mean share over trials
    double worstLateness_us = std::numeric_limits<double>::quiet_NaN();
    std::string device;         ///< models, separated by ", "; empty where nothing was rendered
    std::optional<bool> felt;   ///< false where any trial was only shown; nothing where nothing was rendered
    int presentations = 0;
    int practice = 0;           ///< of these
    int scored = 0;             ///< of these
    std::vector<std::pair<std::string, int>> spoiled; ///< of these: reason, how often; by reason
    double exploration_s = std::numeric_limits<double>::quiet_NaN();    ///< median over scored trials
};

/// What it takes to run one condition with one participant: also while the study is blinded, for whoever conducts the run.
struct ConductedRun {
    std::string condition; ///< id in the design
    std::string sealedCode;
    std::optional<StudyRun> open;   ///< to be gone on with
    std::vector<StudyTrial> trials; ///< of the open run, complete
    std::string designJson; ///< as it is, where lists mask it: what the program renders
};

/// One answer to one question. Overwritten by an erasure: then neither number nor text. Of a condition, read while the study is blinded: by the
/// sealed code, and where conditions differ without its value and time, which could tell them apart (study_blinding.h).
struct QuestionnaireAnswer {
    ParticipantNumber participant = 0;
    std::string questionnaire;
    std::string item;
    std::optional<double> number; ///< likert, number, choice (index from 0)
    std::string text;             ///< free text
    std::string utc;
    StudyRunNumber run = 0;       ///< of a questionnaire that is asked after each condition: the run it was asked after; 0: asked once
    std::string language{};       ///< that the question was shown in ("de"); empty: not recorded
    // Read with it, of the run; not stored with an answer.
    std::string condition{};      ///< id in the design; empty while the study is blinded, and where there is no run
    std::string sealedCode{};     ///< what stands for it then
    bool withheld = false;        ///< there is an answer, and it is told once the study is unblinded
};

} // namespace chiron::database
