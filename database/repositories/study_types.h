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

/// An entry of the list of studies.
struct StudySummary {
    StudyNumber id = 0;
    std::string key;   ///< the design's id
    std::string title; ///< English
    StudyState state = StudyState::draft;
    /// Of the frozen design's canonical JSON, 64 hex digits; empty for a draft.
    std::string sha256;
    PersonId author = 0;
    std::string createdUtc;
    std::string frozenUtc;
    bool unblinded = false;
    bool demonstration = false;
    int participants = 0;
    int completed = 0; ///< number of participants who have completed
    /// Scored trials; while experimenters are blind, only those of participants who have completed.
    int trials = 0;
    /// Key of the study whose draft was tried with this copy; empty: not a pilot.
    std::string pilotOf;
};

/// What the lists of a blinded study omit (study_blinding.h).
struct Blinding {
    bool designed = false; ///< the design blinds experimenters
    bool on = false;       ///< the design blinds, and the study is not unblinded
    // What all conditions have in common, so that it reveals nothing about a run.
    bool oneTask = true;
    bool oneTable = true;     ///< table of differences
    bool oneProcedure = true; ///< procedures, their scale and criterion
    bool oneStimulus = true;  ///< attribute, reference and the other attributes of the objects
    /// The answers of a condition are values in SI (marks of an apex are given as shares of its radius).
    bool adjusts = false;
    bool oneExercise = true; ///< all conditions are of an apex, or none

    /// Returns whether the conditions are alike in everything that the program does. If they are not,
    /// everything that a run leaves behind (answers, times, speeds, number of trials) could reveal its
    /// condition, and none of it is shown before unblinding.
    bool analysable() const { return asksAlike() && oneStimulus; }
    /// Returns whether the conditions ask in the same way, whatever the objects are. A value set in SI also
    /// depends on the objects.
    bool asksAlike() const { return oneTask && oneTable && oneProcedure && (oneStimulus || !adjusts); }
    /// Returns whether trials, and estimates made from them, are withheld.
    bool seals() const { return on && !analysable(); }
};

struct StudyRecord {
    StudySummary summary;
    /// Canonical JSON; catalogue::readStudy converts it to a psychophysics::StudyDesign. If masked, its
    /// conditions have their sealed codes as names, and properties in which they differ have a neutral value
    /// (study_mask.h).
    std::string designJson;
    Blinding blinding; ///< of the design before masking
    /// The design is masked: the study is frozen and blinded, and the reader may not look up which code is
    /// which.
    bool masked = false;
};

/// A participant as shown in exports and to experimenters: never with a name.
struct Participant {
    ParticipantNumber id = 0;
    StudyNumber study = 0;
    std::string code; ///< random, e.g. "K7M-4QX"
    int order = 0;    ///< from 0: row of the order design
    ParticipantState state = ParticipantState::enrolled;
    bool simulated = false;
    std::string observer; ///< specification of a simulated participant's observer
    std::string enrolledUtc;
    std::string consentUtc;    ///< empty: no consent
    std::string consentSha256; ///< of the text to which the participant agreed
    PersonId enrolledBy = 0;
    /// A withdrawn participant wants the recordings erased, too (an administrator does it).
    bool recordingsToErase = false;
    /// Key, free texts and questionnaires (and recordings, if wanted) are overwritten.
    bool erased = false;
};

/// The person behind a code; stored separately, for administrators and the study's author only.
struct ParticipantKey {
    ParticipantNumber participant = 0;
    std::string code;
    std::string identity;           ///< free text, as the researcher wrote it
    std::optional<PersonId> person; ///< set if the participant has an account
    std::string account{};          ///< login name of that account
};

/// One condition done by one participant. A run may extend over several sessions.
struct StudyRun {
    StudyRunNumber id = 0;
    ParticipantNumber participant = 0;
    std::string condition;  ///< id in the design; empty while the study is blinded
    std::string sealedCode; ///< replaces the condition while the study is blinded
    int position = 0;       ///< from 0, in the participant's order
    std::uint64_t seed = 0;
    std::string procedures; ///< ids with version, "rank3_quest_plus@1", comma-separated
    StudyRunState state = StudyRunState::open;
    std::string startedUtc;
    std::string endedUtc;
};

/// The properties with which a run begins.
struct NewStudyRun {
    ParticipantNumber participant = 0;
    std::string condition; ///< id in the design or, while the study is blinded, the sealed code
    int position = 0;      ///< from 0, in the participant's order
    std::uint64_t seed = 0;
    std::string procedures; ///< as StudyRun::procedures
};

/// The name of a condition for a blind experimenter: "Q7M". It is derived from the site's key when the study
/// is frozen, so that it can neither be guessed nor computed from the design.
struct SealedCondition {
    std::string condition;
    std::string sealedCode;
};

/// One presentation, scored or not. Its digest covers all fields; it is never changed or deleted. If it is
/// read while the study is blinded, it lacks everything that would distinguish the conditions
/// (study_blinding.h).
struct StudyTrial {
    StudyRunNumber run = 0;
    int ordinal = 0;       ///< from 0; counts every presentation of the run
    int procedure = 0;     ///< index among the interleaved procedures
    SessionId session = 0; ///< session with its recording; 0: none (a quick simulation)
    std::uint64_t firstTick = 0, lastTick = 0;
    int candidate = 0; ///< row of the table of differences
    int arrangement = 0;
    double difference = 0.0;                                         ///< intended D, log10 of the ratio
    double entropyMargin = std::numeric_limits<double>::quiet_NaN(); ///< absent if NaN
    int answer = -1;                                                 ///< -1: none
    int outcome = -1; ///< outcome given to the procedure; -1: none
    /// The number given (magnitude), or the value set (adjustment), SI.
    std::optional<double> value;
    double exploration_s = 0.0; ///< until the answer
    double answer_s = 0.0;      ///< from the last contact to the answer
    bool practice = false;
    /// Always false when stored; an undo is a separate row that names this one.
    bool undone = false;
    /// Empty: scored; otherwise the reason why not: "force_error", "late_ticks", "saturation", "speed",
    /// "time", "experimenter", "stopped", ...
    std::string spoiled;
    std::string fidelityJson = "{}"; ///< canonical; session::TrialFidelity
    std::string utc;
    // Read from the session with the recording; not stored with a trial.
    std::string device; ///< model of that session's first device; empty without a session
    /// Whether force was rendered or only shown; none without a session.
    std::optional<bool> felt;
};

/// StudyTrial::spoiled of the trial at hand when a run was stopped.
inline constexpr std::string_view kInterrupted = "stopped";

/// Whether a trial did not count because something was wrong with it, so that it was presented again.
/// Practice is never repeated in this sense, nor is the trial that a stop of the run interrupted.
inline bool isRepeated(const StudyTrial& trial) {
    return !trial.practice && !trial.spoiled.empty() && trial.spoiled != kInterrupted;
}

/// The quality of a participant's trials over all conditions together, so that it can be monitored while a
/// study is blinded. Figures that depend on the objects (how often trials were repeated, how long they took)
/// are given only once every condition is completed, because then they belong to no particular one.
struct ParticipantQuality {
    ParticipantNumber participant = 0;
    int conditionsDone = 0; ///< completed runs
    int conditions = 0;     ///< number in the study
    /// Every condition is completed, or the study is not blinded: the fields from `presentations` on are
    /// given.
    bool whole = false;
    double lateTicks = std::numeric_limits<double>::quiet_NaN(); ///< mean share over trials
    double worstLateness_us = std::numeric_limits<double>::quiet_NaN();
    std::string device; ///< models, separated by ", "; empty if nothing was rendered
    /// false if force was only shown in any trial; none if nothing was rendered.
    std::optional<bool> felt;
    int presentations = 0;
    int practice = 0; ///< of the presentations
    int scored = 0;   ///< of the presentations
    /// Of the presentations, those that are repeated (isRepeated): reason and count, by reason.
    std::vector<std::pair<std::string, int>> spoiled;
    double exploration_s = std::numeric_limits<double>::quiet_NaN(); ///< median over scored trials
};

/// What is needed to run one condition with one participant; available to the person who conducts the run,
/// also while the study is blinded.
struct ConductedRun {
    std::string condition; ///< id in the design
    std::string sealedCode;
    std::optional<StudyRun> open;   ///< to be continued
    std::vector<StudyTrial> trials; ///< of the open run, complete
    std::string designJson;         ///< not masked, because the program has to render it
};

/// One answer to one question. After an erasure it has neither number nor text. An answer about a condition,
/// if read while the study is blinded, has the sealed code; if the conditions differ it also lacks its value
/// and time, which could distinguish them (study_blinding.h).
struct QuestionnaireAnswer {
    ParticipantNumber participant = 0;
    std::string questionnaire;
    std::string item;
    std::optional<double> number; ///< likert, number, choice (index from 0)
    std::string text;             ///< free text
    std::string utc;
    /// For a questionnaire that is asked after each condition: the run after which it was asked; 0: asked
    /// once.
    StudyRunNumber run = 0;
    std::string language{}; ///< language in which the question was shown ("de"); empty: not recorded
    // Read from the run; not stored with an answer.
    /// Id in the design; empty while the study is blinded, and if there is no run.
    std::string condition{};
    std::string sealedCode{}; ///< replaces the condition while the study is blinded
    bool withheld = false;    ///< there is an answer, which is shown once the study is unblinded
};

} // namespace chiron::database
