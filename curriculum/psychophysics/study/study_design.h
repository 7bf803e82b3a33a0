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

/// A text in several languages ("en" is always present), UTF-8.
using StudyText = std::map<std::string, std::string>;

/// The x of a procedure for a candidate difference D (log10 of the ratio to the reference).
enum class ProcedureScale : std::uint8_t {
    difference,    ///< "difference": x = D (rank-3, constant stimuli on both sides, adjustment)
    logDifference, ///< "log_difference": x = log10 D (thresholds: staircases, QUEST, QUEST+)
};

/// The stimuli of one condition. The value of an object with multiple m is reference · 10^(m D).
struct StimulusDesign {
    Attribute attribute = Attribute::stiffness;
    double reference = 0.0; ///< SI, unitOf(attribute)
    /// The table of candidates D, ascending, at most 4096; may be negative in tasks that take both sides.
    std::vector<double> differences;
    /// The other attributes of the objects, fixed, by name in SI (keys of content/objects: stiffness_N_per_m,
    /// damping_Ns_per_m, ...).
    std::map<std::string, double> fixed;
};

/// One condition of a study: what is compared, how it is asked, and by which procedures (several are
/// interleaved at random).
struct Condition {
    std::string id; ///< snake_case, unique in the study
    StudyText title;
    StimulusDesign stimulus;
    Task task = Task::rank3;
    ProcedureScale scale = ProcedureScale::difference;
    std::vector<ProcedureSpec> procedures;
    double criterion = 0.75; ///< proportion correct for which the threshold is given
    /// What participants read before this condition, in addition to the study's instructions (a glove, the
    /// other hand); empty: nothing.
    StudyText instructions;
};

/// Default of new studies: three times the friction at the tip of the simulated device (0.1 N, models.md),
/// which a hand cannot tell from an object; six times the force difference that nobody notices (0.05 N); and
/// less than a tenth of the largest force of a trial. Our choice.
inline constexpr double kUsualProbe_N = 0.3;

struct TrialRules {
    double exploreLimit_s = 30.0; ///< 0: none
    double answerLimit_s = 20.0;  ///< 0: none
    double betweenTrials_s = 1.0;
    bool feedback = false;
    bool maskingSound = true;   ///< pink noise, if there is a sound output
    bool visibleObjects = true; ///< all objects are drawn, and look alike
    int practiceTrials = 4;     ///< at the largest difference, with feedback, never scored
    int breakEvery = 40;        ///< trials; 0: none
    double breakAtLeast_s = 30.0;
    bool mustTouchAll = true; ///< an answer is accepted only after every object was touched
    /// Each object must also have answered with at least this force; 0: any touch counts, as in designs of
    /// earlier versions.
    double probeAtLeast_N = 0.0;
};

/// A trial outside these limits is flagged, not scored, and repeated.
struct FidelityLimits {
    double forceErrorRms_N = 0.15; ///< difference between commanded and measured force
    double stiffnessError = 0.15;  ///< |rendered/commanded − 1|
    double lateTicks = 0.01;       ///< share
    double saturated = 0.05;       ///< share of contact ticks in which the force is at its limit
    double peakForce_N = 4.0;
    double meanSpeed_m_per_s = 0.2;
    int repeatsAtMost = 5; ///< of one trial; then the run pauses and asks the experimenter
};

/// One question of a questionnaire.
struct QuestionnaireItem {
    std::string id;
    StudyText text;
    enum class Kind : std::uint8_t { likert, number, choice, text } kind = Kind::likert;
    int scale = 5;       ///< likert: 1..scale
    StudyText low, high; ///< likert: meaning of the two ends
    std::vector<StudyText> choices;
    std::string construct;              ///< "face", "content", "" ...: the heading under which it is
                                        ///< summarised
    double lowest = 0.0, highest = 0.0; ///< number: allowed range
    bool required = true;
};

struct Questionnaire {
    std::string id;
    StudyText title;
    /// `enrolment`: recorded when a participant is enrolled (age, sex, handedness, ...), not asked in a run.
    /// `afterCondition`: asked once after each condition, about that condition.
    enum class When : std::uint8_t { before, after, enrolment, afterCondition } when = When::after;
    std::vector<QuestionnaireItem> items;
    /// Rule that computes scores from the answers (measures/instrument_score.h); empty: none.
    std::string score;
};

enum class OrderDesign : std::uint8_t {
    fixed,
    random,
    latinSquare,
    williams
}; ///< "fixed", "random", "latin_square", "williams"

/// A study as it is designed, frozen and run. Its JSON is described in content/schema/study.json;
/// catalogue/study_json reads and writes it.
struct StudyDesign {
    std::string id; ///< snake_case
    StudyText title;
    StudyText objective;
    StudyText instructions; ///< the complete text that participants read
    /// The researcher's own sentences, if the others in `instructions` are generated from the settings; none:
    /// all sentences are the researcher's.
    std::optional<StudyText> ownInstructions;
    StudyText consent; ///< what participants agree to
    std::vector<Condition> conditions;
    OrderDesign order = OrderDesign::williams;
    TrialRules trial;
    FidelityLimits fidelity;
    std::vector<Questionnaire> questionnaires;
    int participantsPlanned = 12;
    bool blindParticipant = true;   ///< no value, level or condition name on the participant's screen
    bool blindExperimenter = false; ///< conditions are shown by sealed codes until the study is unblinded
    std::uint64_t seed = 1;         ///< for orders, codes and the random streams of every run
    std::string source;             ///< publication of the design, as it is cited; empty: not published
    std::string ethics; ///< who approved the study, or why no approval is needed; empty: not stated
    /// Id of the study whose draft was tried with this copy; empty: this is not a pilot, and its data count.
    std::string pilotOf;
};

} // namespace chiron::psychophysics
