// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/procedure_spec.h"
#include "psychophysics/study/arrangement.h"
#include "psychophysics/study/attribute.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// A text in several languages ("en" always), UTF-8.
using StudyText = std::map<std::string, std::string>;

/// What the x of a procedure is, for a candidate difference D (log10 of the ratio to the reference).
enum class ProcedureScale : std::uint8_t {
    difference,    ///< "difference": x = D (rank-3, constant stimuli on both sides, adjustment)
    logDifference, ///< "log_difference": x = log10 D (thresholds: staircases, QUEST, QUEST+)
};

/// What is felt in one condition. Value at a place with multiple m: reference · 10^(m D).
struct StimulusDesign {
    Attribute attribute = Attribute::stiffness;
    double reference = 0.0;          ///< SI, unitOf(attribute)
    std::vector<double> differences; ///< the table of candidates D, ascending, at most 4096; may be negative on both-sided tasks
    /// What the objects otherwise are: fixed attributes by name in SI (keys of content/objects: stiffness_N_per_m, damping_Ns_per_m, ...).
    std::map<std::string, double> fixed;
};

/// One condition of a study: what is compared, how it is asked, by which procedures (several: interleaved at random).
struct Condition {
    std::string id; ///< snake_case, unique in the study
    StudyText title;
    StimulusDesign stimulus;
    Task task = Task::rank3;
    ProcedureScale scale = ProcedureScale::difference;
    std::vector<ProcedureSpec> procedures;
    double criterion = 0.75; ///< proportion correct that the threshold is given for
    StudyText instructions;  ///< what participants read before this condition, beside the study's: a glove, the other hand; empty: nothing
};

/// What new studies begin with: three times the friction at the tip of the simulated device (0.1 N, models.md), which a hand cannot tell from an
/// object, six times the force of which nobody notices more or less (0.05 N), and less than a tenth of the largest force of a trial. Our choice.
inline constexpr double kUsualProbe_N = 0.3;

struct TrialRules {
    double exploreLimit_s = 30.0;   ///< 0: none
    double answerLimit_s = 20.0;    ///< 0: none
    double betweenTrials_s = 1.0;
    bool feedback = false;
    bool maskingSound = true;       ///< pink noise, where there is a sound output
    bool visibleObjects = true;     ///< the places are drawn, all alike
    int practiceTrials = 4;         ///< at the largest difference, with feedback, never scored
    int breakEvery = 40;            ///< trials; 0: none
    double breakAtLeast_s = 30.0;
    bool mustTouchAll = true;       ///< an answer is taken only once every place was touched
    double probeAtLeast_N = 0.0;    ///< and its object answered with so much; 0: any touch counts, as in designs of earlier versions
};

/// A trial outside these is flagged, not scored and repeated.
struct FidelityLimits {
    double forceErrorRms_N = 0.15;     ///< commanded against measured
    double stiffnessError = 0.15;      ///< |rendered/commanded − 1|
    double lateTicks = 0.01;           ///< share
    double saturated = 0.05;           ///< share of contact ticks with the force at its limit
    double peakForce_N = 4.0;
    double meanSpeed_m_per_s = 0.2;
    int repeatsAtMost = 5;             ///< of one trial; then the run pauses and asks the experimenter
};

/// One question of a questionnaire.
struct QuestionnaireItem {
    std::string id;
    StudyText text;
    enum class Kind : std::uint8_t { likert, number, choice, text } kind = Kind::likert;
    int scale = 5;                     ///< likert: 1..scale
    StudyText low, high;               ///< likert: what the ends mean
    std::vector<StudyText> choices;
    std::string construct;             ///< "face", "content", "" ...: what it is summarised under
    double lowest = 0.0, highest = 0.0; ///< number
    bool required = true;
};

struct Questionnaire {
    std::string id;
    StudyText title;
    /// `enrolment`: what is written down of a participant when they are enrolled (age, sex, handedness, ...), not asked at a sitting.
    /// `afterCondition`: once after each condition, about that condition.
    enum class When : std::uint8_t { before, after, enrolment, afterCondition } when = When::after;
    std::vector<QuestionnaireItem> items;
    std::string score; ///< rule that makes scores of the answers (measures/instrument_score.h); empty: none
};

enum class OrderDesign : std::uint8_t { fixed, random, latinSquare, williams }; ///< "fixed", "random", "latin_square", "williams"

/// A study as it is designed, frozen and run. JSON: content/schema/study.json; catalogue/study_reader reads and writes it.
struct StudyDesign {
    std::string id; ///< snake_case
    StudyText title;
    StudyText objective;
    StudyText instructions; ///< what participants read, all of it
    /// The researcher's own sentences, where the others of `instructions` are made from the settings; nothing: all of them are the researcher's.
    std::optional<StudyText> ownInstructions;
    StudyText consent;      ///< what they agree to
    std::vector<Condition> conditions;
    OrderDesign order = OrderDesign::williams;
    TrialRules trial;
    FidelityLimits fidelity;
    std::vector<Questionnaire> questionnaires;
    int participantsPlanned = 12;
    bool blindParticipant = true;   ///< no value, level or condition name on the participant's screen
    bool blindExperimenter = false; ///< conditions are shown by sealed codes until the study is unblinded
    std::uint64_t seed = 1;         ///< of orders, codes and every run's streams
    std::string source;  ///< where the design was published, as it is cited; empty: nowhere
    std::string ethics;  ///< who approved the study, or why that is not needed; empty: not stated
    std::string pilotOf; ///< id of the study whose draft was tried with this copy; empty: no pilot, its data count
};

} // namespace chiron::psychophysics
