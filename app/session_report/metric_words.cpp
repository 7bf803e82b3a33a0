// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/metric_words.h"

#include "scoring/undefined_reason.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace chiron::session_report {

using scoring::UndefinedReason;

namespace {

struct MetricWords {
    const char* id;
    const char* title;
    const char* meaning;
};

// clang-format off
constexpr auto kMetrics = std::to_array<MetricWords>({
    {"time", QT_TRANSLATE_NOOP("Metrics", "Time"),
     QT_TRANSLATE_NOOP("Metrics", "From the first movement or touch of each trial to its end, added up; pauses do not count.")},
    {"path_length", QT_TRANSLATE_NOOP("Metrics", "Path length"),
     QT_TRANSLATE_NOOP("Metrics", "How far the tip of the tool travelled in all trials together.")},
    {"path_inefficiency", QT_TRANSLATE_NOOP("Metrics", "Path inefficiency"),
     QT_TRANSLATE_NOOP("Metrics", "How much longer the path was than the shortest one: the straight line or, where the route "
                                  "bends, the route itself; the mean over the trials.")},
    {"sparc", QT_TRANSLATE_NOOP("Metrics", "Smoothness (SPARC)"),
     QT_TRANSLATE_NOOP("Metrics", "How even the speed of each movement was, calculated from its spectrum. Closer to zero is smoother.")},
    {"ldlj", QT_TRANSLATE_NOOP("Metrics", "Smoothness (LDLJ)"),
     QT_TRANSLATE_NOOP("Metrics", "How free of jerks each movement was. Closer to zero is smoother.")},
    {"force_max", QT_TRANSLATE_NOOP("Metrics", "Largest force"),
     QT_TRANSLATE_NOOP("Metrics", "The largest force on the tissue at any moment.")},
    {"force_mean", QT_TRANSLATE_NOOP("Metrics", "Mean force in contact"),
     QT_TRANSLATE_NOOP("Metrics", "The mean force on the tissue while the tool touched it.")},
    {"force_rms", QT_TRANSLATE_NOOP("Metrics", "Force, root mean square"),
     QT_TRANSLATE_NOOP("Metrics", "The root mean square of the force on the tissue: high forces weigh more than in the mean.")},
    {"force_p95", QT_TRANSLATE_NOOP("Metrics", "Force, 95th percentile"),
     QT_TRANSLATE_NOOP("Metrics", "The force on the tissue was below this for 95 % of the time.")},
    {"force_peak_rate", QT_TRANSLATE_NOOP("Metrics", "Peak force rate"),
     QT_TRANSLATE_NOOP("Metrics", "The fastest rise or fall of the force on the tissue.")},
    {"force_impulse_over_limit", QT_TRANSLATE_NOOP("Metrics", "Impulse over the limit"),
     QT_TRANSLATE_NOOP("Metrics", "Force times time while the force was over the limit of this level.")},
    {"force_time_over_limit", QT_TRANSLATE_NOOP("Metrics", "Time over the force limit"),
     QT_TRANSLATE_NOOP("Metrics", "How long the force on the tissue was over the limit of this level.")},
    {"offset_rms", QT_TRANSLATE_NOOP("Metrics", "Off-centre distance, root mean square"),
     QT_TRANSLATE_NOOP("Metrics", "How far the tip was from the middle of the urethra, on the way in and out: large distances weigh more than in the mean.")},
    {"offset_max", QT_TRANSLATE_NOOP("Metrics", "Largest off-centre distance"),
     QT_TRANSLATE_NOOP("Metrics", "The largest distance of the tip from the middle of the urethra.")},
    {"alignment_rms", QT_TRANSLATE_NOOP("Metrics", "Alignment, root mean square"),
     QT_TRANSLATE_NOOP("Metrics", "The angle between the endoscope and the direction of the urethra where its tip was; large angles weigh more. In the picture: the wall near the tip is equally wide all round when the two are in line. The ring shows where the urethra leads farther ahead, so in a bend a few degrees remain although it is in the centre; the pass marks allow for them.")},
    {"bend_alignment", QT_TRANSLATE_NOOP("Metrics", "Alignment at the bend"),
     QT_TRANSLATE_NOOP("Metrics", "The angle between the endoscope and the urethra at its tip, on the way in, within 10 mm of the bend, where the endoscope has to be turned. In line, the wall near the tip is equally wide all round.")},
    {"curve_alignment", QT_TRANSLATE_NOOP("Metrics", "Alignment round the bend"),
     QT_TRANSLATE_NOOP("Metrics", "The angle between the endoscope and the urethra at its tip, on the way in, from the bend to 30 mm past it, where the urethra is curved most. In line, the wall near the tip is equally wide all round.")},
    {"trauma_events", QT_TRANSLATE_NOOP("Metrics", "Trauma events"),
     QT_TRANSLATE_NOOP("Metrics", "How often the endoscope pressed sideways on the wall over the limit of this level for 20 ms or longer.")},
    {"trauma_time", QT_TRANSLATE_NOOP("Metrics", "Trauma time"),
     QT_TRANSLATE_NOOP("Metrics", "How long these events lasted in total.")},
    {"trauma_impulse", QT_TRANSLATE_NOOP("Metrics", "Trauma impulse"),
     QT_TRANSLATE_NOOP("Metrics", "Sideways force times time while that force was over the limit of this level.")},
    {"lateral_max", QT_TRANSLATE_NOOP("Metrics", "Largest sideways force"),
     QT_TRANSLATE_NOOP("Metrics", "The largest force with which the endoscope pressed sideways on the wall at any moment.")},
    {"advance_while_turning", QT_TRANSLATE_NOOP("Metrics", "Advance while turning"),
     QT_TRANSLATE_NOOP("Metrics", "How far the endoscope was pushed on in the bend while it was being turned: stop, turn, and only then go on.")},
    {"torque_max", QT_TRANSLATE_NOOP("Metrics", "Largest torque"),
     QT_TRANSLATE_NOOP("Metrics", "The largest torque between endoscope and tissue at any moment.")},
    {"torque_rms", QT_TRANSLATE_NOOP("Metrics", "Torque, root mean square"),
     QT_TRANSLATE_NOOP("Metrics", "The root mean square of the torque between endoscope and tissue.")},
    {"reversals", QT_TRANSLATE_NOOP("Metrics", "Reversals"),
     QT_TRANSLATE_NOOP("Metrics", "How often the tip went back by 1 mm or more on the way in.")},
    {"landmarks_seen", QT_TRANSLATE_NOOP("Metrics", "Landmarks seen"),
     QT_TRANSLATE_NOOP("Metrics", "The landmarks of the bladder that were inspected, in % of those that the level asks for.")},
    {"procedure_completed", QT_TRANSLATE_NOOP("Metrics", "Procedure completed"),
     QT_TRANSLATE_NOOP("Metrics", "How many of the trials were completed in time, with everything that the level asks for, in %.")},
    {"inspection_travel", QT_TRANSLATE_NOOP("Metrics", "Tip travel during inspection"),
     QT_TRANSLATE_NOOP("Metrics", "How far the tip travelled while the bladder was inspected: turning it shows as much and harms less.")},
    {"insertion_depth", QT_TRANSLATE_NOOP("Metrics", "Insertion depth"),
     QT_TRANSLATE_NOOP("Metrics", "How deep the tip went, counted up to the goal of this level.")},
    {"tension_error_rms", QT_TRANSLATE_NOOP("Metrics", "Tension error, root mean square"),
     QT_TRANSLATE_NOOP("Metrics", "How far the tension of the tube was from its target while it was held: large differences weigh more than in the mean.")},
    {"tension_error_sd", QT_TRANSLATE_NOOP("Metrics", "Tension error, standard deviation"),
     QT_TRANSLATE_NOOP("Metrics", "How unsteady the tension of the tube was while it was held, whether on target or not.")},
    {"time_in_band", QT_TRANSLATE_NOOP("Metrics", "Time in the band"),
     QT_TRANSLATE_NOOP("Metrics", "How long the tension, or the length at the mark, stayed in its band during the hold; the mean over all "
                                  "trials.")},
    {"retraction_time_in_band", QT_TRANSLATE_NOOP("Metrics", "Retraction in the band"),
     QT_TRANSLATE_NOOP("Metrics", "How much of the time the pull on the fold of tissue was in its band, once the fold was held back, in %; "
                                  "the mean over all trials.")},
    {"retraction_max", QT_TRANSLATE_NOOP("Metrics", "Largest retraction"),
     QT_TRANSLATE_NOOP("Metrics", "The largest pull on the fold of tissue at any moment.")},
    {"over_stretches", QT_TRANSLATE_NOOP("Metrics", "Over-stretches"),
     QT_TRANSLATE_NOOP("Metrics", "How often the tube was stretched beyond the limit of this level.")},
    {"critical_errors", QT_TRANSLATE_NOOP("Metrics", "Critical errors"),
     QT_TRANSLATE_NOOP("Metrics", "How often the tissue gave way because it was pushed or turned too hard, or was pressed sideways too hard or for too long.")},
    {"drops", QT_TRANSLATE_NOOP("Metrics", "Drops"),
     QT_TRANSLATE_NOOP("Metrics", "How often the tissue was let go of before the task was done.")},
    {"squeeze_max", QT_TRANSLATE_NOOP("Metrics", "Largest squeeze"),
     QT_TRANSLATE_NOOP("Metrics", "The largest force with which the jaws squeezed what they held.")},
    {"squeeze_time_over_limit", QT_TRANSLATE_NOOP("Metrics", "Time squeezing too hard"),
     QT_TRANSLATE_NOOP("Metrics", "How long the squeeze was over the limit of this level.")},
    {"placement_error", QT_TRANSLATE_NOOP("Metrics", "Placement error"),
     QT_TRANSLATE_NOOP("Metrics", "How far from the middle of the target the object lay at the end of each trial; the mean over the trials.")},
    {"weighing_correct", QT_TRANSLATE_NOOP("Metrics", "Heaviest found"),
     QT_TRANSLATE_NOOP("Metrics", "How often the heaviest object was put into the target, in % of the trials.")},
    {"weighing_correct_by_chance", QT_TRANSLATE_NOOP("Metrics", "Heaviest found by chance"),
     QT_TRANSLATE_NOOP("Metrics", "How often somebody who feels nothing would choose the heaviest object. A share that is not larger shows "
                                  "no skill.")},
    {"prediction_error_rms", QT_TRANSLATE_NOOP("Metrics", "Prediction error at 30 Hz"),
     QT_TRANSLATE_NOOP("Metrics", "How far the predicted soft surface under the tool was from the result of the slow model; this rates the "
                                  "simulation, not you.")},
    {"held_error_rms", QT_TRANSLATE_NOOP("Metrics", "Error without prediction"),
     QT_TRANSLATE_NOOP("Metrics", "The same error if the last update had been kept instead: the difference shows what the prediction is "
                                  "worth.")},
    {"palpation_hits", QT_TRANSLATE_NOOP("Metrics", "Lumps found"),
     QT_TRANSLATE_NOOP("Metrics", "Lumps with a finding near enough to them. A lump that was pressed harder than the limit does not count.")},
    {"palpation_misses", QT_TRANSLATE_NOOP("Metrics", "Lumps missed"),
     QT_TRANSLATE_NOOP("Metrics", "Lumps with no finding near enough to them.")},
    {"palpation_false_alarms", QT_TRANSLATE_NOOP("Metrics", "False alarms"),
     QT_TRANSLATE_NOOP("Metrics", "Findings where there was no lump; a second finding of the same lump counts too.")},
    {"palpation_d_prime", QT_TRANSLATE_NOOP("Metrics", "Sensitivity (d′)"),
     QT_TRANSLATE_NOOP("Metrics", "How well places with a lump were told apart from places without, whatever the tendency to say yes or "
                                  "no. 0 is chance.")},
    {"palpation_d_prime_low", QT_TRANSLATE_NOOP("Metrics", "Sensitivity, lower bound"),
     QT_TRANSLATE_NOOP("Metrics", "The lower end of the 95 % interval of the sensitivity. Below 0 the session does not show that anything was felt.")},
    {"palpation_d_prime_high", QT_TRANSLATE_NOOP("Metrics", "Sensitivity, upper bound"),
     QT_TRANSLATE_NOOP("Metrics", "The upper end of the 95 % interval of the sensitivity.")},
    {"palpation_criterion", QT_TRANSLATE_NOOP("Metrics", "Criterion (c)"),
     QT_TRANSLATE_NOOP("Metrics", "The tendency when in doubt: to report a lump (negative) or not to report one (positive).")},
    {"palpation_roc_area", QT_TRANSLATE_NOOP("Metrics", "Area under the ROC curve"),
     QT_TRANSLATE_NOOP("Metrics", "How well confidence tells places with a lump from places without: 0.5 is chance, 1 is perfect.")},
    {"localisation_error", QT_TRANSLATE_NOOP("Metrics", "Localisation error"),
     QT_TRANSLATE_NOOP("Metrics", "How far, on the surface, each finding was from the lump that it found; the mean over all lumps found.")},
    {"localisation_error_by_chance", QT_TRANSLATE_NOOP("Metrics", "Localisation error by chance"),
     QT_TRANSLATE_NOOP("Metrics", "How far findings would be from a lump if they hit it at random. A localisation error that is not "
                                  "smaller shows no skill.")},
    {"size_error", QT_TRANSLATE_NOOP("Metrics", "Size error"),
     QT_TRANSLATE_NOOP("Metrics", "How far the stated radius was from the true one; the mean over all lumps found with a stated size.")},
    {"size_error_by_chance", QT_TRANSLATE_NOOP("Metrics", "Size error by chance"),
     QT_TRANSLATE_NOOP("Metrics", "The size error of somebody who feels nothing and always states the middle size. A size error that is "
                                  "not smaller shows no skill.")},
    {"hardness_order", QT_TRANSLATE_NOOP("Metrics", "Hardness order"),
     QT_TRANSLATE_NOOP("Metrics", "In how many pairs of lumps found in a trial the harder one was rated harder, in %. Guessing gives 50 % "
                                  "or less.")},
    {"hardness_order_by_chance", QT_TRANSLATE_NOOP("Metrics", "Hardness order by chance"),
     QT_TRANSLATE_NOOP("Metrics", "The hardness order of somebody who assigns the same hardness ratings to the lumps at random. A share "
                                  "that is not larger shows no skill.")},
    {"coverage", QT_TRANSLATE_NOOP("Metrics", "Area covered"),
     QT_TRANSLATE_NOOP("Metrics", "How much of the search area was pressed hard enough to find something; the mean over the trials.")},
    {"force_band_time", QT_TRANSLATE_NOOP("Metrics", "Time in the force band"),
     QT_TRANSLATE_NOOP("Metrics", "How much of the pressing time the force was neither too low nor too high.")},
    {"pressing_time", QT_TRANSLATE_NOOP("Metrics", "Time pressing"),
     QT_TRANSLATE_NOOP("Metrics", "How long a finger pressed the tissue, in all trials together.")},
    {"searching_time", QT_TRANSLATE_NOOP("Metrics", "Time searching"),
     QT_TRANSLATE_NOOP("Metrics", "How long the trials took until the search was reported as done; pauses do not count.")},
    {"apex_error_mean", QT_TRANSLATE_NOOP("Metrics", "Apex error, mean"),
     QT_TRANSLATE_NOOP("Metrics", "How far the marks lay from the highest point, in % of the radius; the mean over both axes and all trials, misses included.")},
    {"apex_error_mean_by_chance", QT_TRANSLATE_NOOP("Metrics", "Apex error by chance"),
     QT_TRANSLATE_NOOP("Metrics", "The apex error of somebody who feels nothing and always marks the same, best possible place. An error "
                                  "that is not smaller shows no skill.")},
    {"apex_error_sd", QT_TRANSLATE_NOOP("Metrics", "Apex error, standard deviation"),
     QT_TRANSLATE_NOOP("Metrics", "How much the error differed from mark to mark.")},
    {"apex_bias_x", QT_TRANSLATE_NOOP("Metrics", "Apex bias, left to right"),
     QT_TRANSLATE_NOOP("Metrics", "Whether the marks lay to one side: the mean error to the right (positive) or left (negative).")},
    {"apex_bias_y", QT_TRANSLATE_NOOP("Metrics", "Apex bias, front to back"),
     QT_TRANSLATE_NOOP("Metrics", "Whether the marks lay to one side: the mean error away from (positive) or towards (negative) the person.")},
    {"apex_misses", QT_TRANSLATE_NOOP("Metrics", "Misses"),
     QT_TRANSLATE_NOOP("Metrics", "Trials marked without touching, marked beside the sphere, or not marked in time. Their errors count all the same.")},
});

/// By the reason and not by its stored text, in the enumeration's order: a reason without words does not compile.
constexpr auto kReasons = std::to_array<std::pair<UndefinedReason, const char*>>({
    {UndefinedReason::noForces, QT_TRANSLATE_NOOP("Metrics", "the recording has no forces")},
    {UndefinedReason::noTrials, QT_TRANSLATE_NOOP("Metrics", "no trials")},
    {UndefinedReason::noneFinished, QT_TRANSLATE_NOOP("Metrics", "no trial was finished")},
    {UndefinedReason::notFinished, QT_TRANSLATE_NOOP("Metrics", "the trial was not finished")},
    {UndefinedReason::noSamples, QT_TRANSLATE_NOOP("Metrics", "no samples")},
    {UndefinedReason::tooFewSamples, QT_TRANSLATE_NOOP("Metrics", "fewer than two samples")},
    {UndefinedReason::tooFewPositions, QT_TRANSLATE_NOOP("Metrics", "fewer than two positions")},
    {UndefinedReason::noContact, QT_TRANSLATE_NOOP("Metrics", "no contact")},
    {UndefinedReason::endsTooNear, QT_TRANSLATE_NOOP("Metrics", "start and end are less than 5 mm apart")},
    {UndefinedReason::neitherMovementNorContact, QT_TRANSLATE_NOOP("Metrics", "neither movement nor contact")},
    {UndefinedReason::noMovement, QT_TRANSLATE_NOOP("Metrics", "no movement")},
    {UndefinedReason::noSubMovement, QT_TRANSLATE_NOOP("Metrics", "no sub-movement of at least 100 ms")},
    {UndefinedReason::noSpectrum, QT_TRANSLATE_NOOP("Metrics", "speed has no spectrum up to 10 Hz")},
    {UndefinedReason::tooFewSpeeds, QT_TRANSLATE_NOOP("Metrics", "fewer than three speed samples")},
    {UndefinedReason::noJerk, QT_TRANSLATE_NOOP("Metrics", "no jerk: speed changes evenly")},
    {UndefinedReason::needsTwoTrials, QT_TRANSLATE_NOOP("Metrics", "needs two trials or more")},
    {UndefinedReason::oneTrialHasNoChance, QT_TRANSLATE_NOOP("Metrics", "there is no chance level for a single trial")},
    {UndefinedReason::noPosition, QT_TRANSLATE_NOOP("Metrics", "no position to score")},
    {UndefinedReason::apexUnknown, QT_TRANSLATE_NOOP("Metrics", "the true position of the apex is not known")},
    {UndefinedReason::noInsertionData, QT_TRANSLATE_NOOP("Metrics", "the recording has no insertion data")},
    {UndefinedReason::noProcedure, QT_TRANSLATE_NOOP("Metrics", "the recording has no procedure")},
    {UndefinedReason::noTorques, QT_TRANSLATE_NOOP("Metrics", "the recording has no torques")},
    {UndefinedReason::neverInUrethra, QT_TRANSLATE_NOOP("Metrics", "the tip was never in the urethra")},
    {UndefinedReason::neverAtBend, QT_TRANSLATE_NOOP("Metrics", "the tip was never at the bend")},
    {UndefinedReason::noLandmarks, QT_TRANSLATE_NOOP("Metrics", "the level has no landmarks")},
    {UndefinedReason::inspectionNotReached, QT_TRANSLATE_NOOP("Metrics", "the inspection was not reached")},
    {UndefinedReason::noTubeData, QT_TRANSLATE_NOOP("Metrics", "the recording has no tube data")},
    {UndefinedReason::noSuchTarget, QT_TRANSLATE_NOOP("Metrics", "the task has no such target")},
    {UndefinedReason::tensionNeverHeld, QT_TRANSLATE_NOOP("Metrics", "the tension was never held")},
    {UndefinedReason::noSqueeze, QT_TRANSLATE_NOOP("Metrics", "the recording has no squeeze")},
    {UndefinedReason::noSqueezeLimit, QT_TRANSLATE_NOOP("Metrics", "the recording has no squeeze limit")},
    {UndefinedReason::noObjectsAndTarget, QT_TRANSLATE_NOOP("Metrics", "the recording has neither objects nor a target")},
    {UndefinedReason::noWeighing, QT_TRANSLATE_NOOP("Metrics", "the level asks for no weighing")},
    {UndefinedReason::noLumpsAndArea, QT_TRANSLATE_NOOP("Metrics", "the recording has neither lumps nor a search area")},
    {UndefinedReason::noReports, QT_TRANSLATE_NOOP("Metrics", "the recording has no reports")},
    {UndefinedReason::lostReports, QT_TRANSLATE_NOOP("Metrics", "reports are missing from the recording")},
    {UndefinedReason::noLumpThere, QT_TRANSLATE_NOOP("Metrics", "there was no lump")},
    {UndefinedReason::noLumpFound, QT_TRANSLATE_NOOP("Metrics", "no lump was found")},
    {UndefinedReason::noConfidence, QT_TRANSLATE_NOOP("Metrics", "no finding has a confidence rating")},
    {UndefinedReason::noSizeSaid, QT_TRANSLATE_NOOP("Metrics", "no lump found was given a size")},
    {UndefinedReason::noSizeAsked, QT_TRANSLATE_NOOP("Metrics", "the level asks for no size")},
    {UndefinedReason::noHardnessAsked, QT_TRANSLATE_NOOP("Metrics", "the level asks for no hardness")},
    {UndefinedReason::tooFewHardnessOfATrial, QT_TRANSLATE_NOOP("Metrics", "in no trial were two lumps found and given a hardness")},
    {UndefinedReason::tooFewHardness, QT_TRANSLATE_NOOP("Metrics", "fewer than two lumps were found and given a hardness")},
    {UndefinedReason::equallyHard, QT_TRANSLATE_NOOP("Metrics", "the lumps that were found are equally hard")},
    {UndefinedReason::noUnequalPair, QT_TRANSLATE_NOOP("Metrics", "no two lumps of different hardness were found and rated")},
    {UndefinedReason::tooFewLumps, QT_TRANSLATE_NOOP("Metrics", "there were fewer than two lumps")},
    {UndefinedReason::tooFewRegions, QT_TRANSLATE_NOOP("Metrics", "only %1 regions with a lump and %2 without: %3 of each are needed")},
    {UndefinedReason::noCoverage, QT_TRANSLATE_NOOP("Metrics", "the recording has no coverage data")},
    {UndefinedReason::noForceBand, QT_TRANSLATE_NOOP("Metrics", "the recording has no force band")},
    {UndefinedReason::nothingPressed, QT_TRANSLATE_NOOP("Metrics", "nothing was pressed")},
    {UndefinedReason::nothingPredicted, QT_TRANSLATE_NOOP("Metrics", "nothing was touched, so nothing was predicted")},
    {UndefinedReason::noPrediction, QT_TRANSLATE_NOOP("Metrics", "the recording has no prediction")},
});
static_assert(kReasons.size() == scoring::kUndefinedReasons);
static_assert([] {
    for (std::size_t i = 0; i < kReasons.size(); ++i)
        if (kReasons[i].first != static_cast<UndefinedReason>(i))
            return false;
    return true;
}());

constexpr std::array<const char*, 1> kBandSources{{
    QT_TRANSLATE_NOOP("Metrics", "published, 5 subjects × 10"),
}};
// clang-format on

QString inLanguage(const QString& text, const char* source) {
    return text == QString::fromUtf8(source) ? QCoreApplication::translate("Metrics", source) : QString();
}

const MetricWords* wordsOf(const QString& id) {
    for (const MetricWords& words : kMetrics)
        if (id == QLatin1String(words.id))
            return &words;
    return nullptr;
}

/// What guessing reaches whatever was there. d′ and ROC: models.md §6.
constexpr std::array<std::pair<std::string_view, double>, 4> kChance{{
    {"palpation_d_prime", 0.0},
    {"palpation_roc_area", 0.5},
    {"hardness_order", 50.0}, // of two lumps, the harder one is named by luck half of the time
    {"weighing_correct", 100.0 / 3.0}, // three objects (P2, Preliminary Validation)
}};

std::optional<double> valueIn(const scoring::ScoreCard& card, std::string_view id) {
    const auto found = std::find_if(card.metrics.begin(), card.metrics.end(), [id](const auto& metric) { return metric.id == id; });
    return found == card.metrics.end() ? std::nullopt : found->value;
}

} // namespace

QString metricTitle(const QString& id) {
    const MetricWords* words = wordsOf(id);
    return words ? QCoreApplication::translate("Metrics", words->title) : QString(id).replace(QLatin1Char('_'), QLatin1Char(' '));
}

QString metricMeaning(const QString& id) {
    const MetricWords* words = wordsOf(id);
    return words ? QCoreApplication::translate("Metrics", words->meaning) : QString();
}

QString metricReason(const QString& stored) {
    const auto undefined = scoring::undefinedOf(stored.toStdString());
    if (!undefined)
        return stored;
    QString words = QCoreApplication::translate("Metrics", kReasons[static_cast<std::size_t>(undefined->reason)].second);
    for (std::size_t i = 0; i < scoring::countsOf(undefined->reason); ++i)
        words = words.arg(undefined->counts[i]);
    return words;
}

QString unitText(const QString& unit) {
    constexpr const char* kOfRadius = QT_TRANSLATE_NOOP("Metrics", "% of R");
    const QString words = inLanguage(unit, kOfRadius);
    return words.isEmpty() ? unit : words;
}

QString bandSourceText(const QString& source) {
    for (const char* known : kBandSources)
        if (const QString text = inLanguage(source, known); !text.isEmpty())
            return text;
    return source;
}

std::optional<double> chanceOf(const std::string& id, const scoring::ScoreCard& card) {
    if (id == "size_error")
        return valueIn(card, "size_error_by_chance");
    const auto known = std::find_if(kChance.begin(), kChance.end(), [&id](const auto& chance) { return chance.first == id; });
    return known == kChance.end() ? std::nullopt : std::optional(known->second);
}

} // namespace chiron::session_report
