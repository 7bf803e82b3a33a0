// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/study/warning.h"

#include <algorithm>
#include <array>
#include <utility>

namespace chiron::psychophysics {

namespace {

/// Texts are "token: words". # stands for the count, @ for the count with "participants", % for the total, $
/// for the detail. In the order of the kinds.
constexpr std::array<std::pair<WarningKind, std::string_view>, static_cast<std::size_t>(WarningKind::end)>
    kEnglish{{
        {WarningKind::leftOutTrials,
         "left_out: # trials have no usable difference or answer and were left out"},
        {WarningKind::noTrials, "no_trials: there is no scored trial, so there is nothing to estimate"},
        {WarningKind::fewTrials, "few_trials: only # trials; the interval is wide and leans on the prior"},
        {WarningKind::noDifference,
         "no_difference: the objects never differed, so nothing can be told about differences"},
        {WarningKind::oneLevel,
         "one_level: only one difference was presented; lapses cannot be told from a high threshold"},
        {WarningKind::binned,
         "binned: very many different differences were presented; neighbouring ones were put together"},
        {WarningKind::oneAnswer,
         "one_answer: the same answer was given every time; the data say nothing about sensitivity"},
        {WarningKind::allRight, "all_right: every answer was right; the threshold may be below the smallest "
                                "difference, how far is not known"},
        {WarningKind::chance,
         "chance: no better than guessing; the threshold may be above the largest difference presented"},
        {WarningKind::priorEdgeLow,
         "prior_edge: the data say nothing at the lower end: the estimate is where the prior put it"},
        {WarningKind::priorEdgeHigh,
         "prior_edge: the data say nothing at the upper end: the estimate is where the prior put it"},
        {WarningKind::priorBoundLow,
         "prior_bound: the lower end of the interval is set by the prior, not by the data"},
        {WarningKind::priorBoundHigh,
         "prior_bound: the upper end of the interval is set by the prior, not by the data"},
        {WarningKind::lapses,
         "lapses: more than a tenth of the answers look like guesses even where the difference was easy"},
        {WarningKind::stepFunction, "step_function: answers jump from guessing to always right between two "
                                    "neighbouring differences; the slope is not known"},
        {WarningKind::positionBias,
         "position_bias: wrong answers fall on one place much more often than chance allows"},
        {WarningKind::poorFit,
         "poor_fit: the curve does not describe the answers; attention or strategy may have changed"},
        {WarningKind::curvesDisagree,
         "curves_disagree: the free curve puts the threshold elsewhere than the Thurstone observer"},
        {WarningKind::noRise,
         "no_rise: answers do not get better as the intensity grows, so there is no threshold to find"},
        {WarningKind::notMonotone, "not_monotone: answers get worse as the intensity grows; check that "
                                   "intensity and answers belong together"},
        {WarningKind::noReference,
         "reference: the condition has no reference above zero, so nothing can be given in its unit"},
        {WarningKind::leftOutSettings, "left_out: # settings are not numbers above zero and were left out"},
        {WarningKind::noSettings, "no_trials: there is no setting, so there is nothing to estimate"},
        {WarningKind::fewSettings, "few_trials: only # settings; their spread is hardly known"},
        {WarningKind::noSpread,
         "no_spread: all settings are the same; the step of the adjustment may be too coarse"},
        {WarningKind::noSettingReference, "reference: the condition has no reference above zero"},
        {WarningKind::leftOutNumbers, "left_out: # answers are not numbers above zero and were left out"},
        {WarningKind::noNumbers, "no_trials: there is no answer, so there is nothing to estimate"},
        {WarningKind::fewNumbers, "few_trials: only # answers"},
        {WarningKind::oneStimulus,
         "one_level: nobody was given two different stimuli, so there is no exponent"},
        {WarningKind::fewSubjects,
         "few_subjects: # with an exponent; the interval is not one of a population"},
        {WarningKind::leftOutParticipants,
         "left_out: # participants have no Weber fraction that their data support"},
        {WarningKind::noParticipants, "no_participants: nobody's data give a Weber fraction"},
        {WarningKind::oneParticipant,
         "few_participants: one participant is not a group; there is no interval"},
        {WarningKind::fewParticipants, "few_participants: only #; the spread between people is hardly known"},
        {WarningKind::heterogeneous,
         "heterogeneous: people differ by more than their own errors; read the prediction interval too"},
        {WarningKind::withdrawn, "withdrawn: @ who withdrew left out"},
        {WarningKind::simulatedLeftOut, "simulated_left_out: @ simulated left out: the group is of people"},
        {WarningKind::simulatedOnly, "simulated: the group is of simulated participants alone"},
        {WarningKind::notRenderedOfGroup,
         "not_rendered: @ of the group without rendering: told the values, nothing was felt"},
        {WarningKind::notRenderedRun,
         "not_rendered: a quick simulation without rendering: the observer was told the values"},
        {WarningKind::sealed, "sealed: conditions differ in what an analysis needs to know: there is an "
                              "estimate once the study is unblinded"},
        {WarningKind::noRadius, "radius: the hemisphere has no radius above zero"},
        {WarningKind::leftOutMarks, "left_out: # trials have no finite error"},
        {WarningKind::noMarks, "no_trials: there is nothing to summarise"},
        {WarningKind::fewMarkers, "few_participants: only #; the spread between people is hardly known"},
        {WarningKind::fewMarks, "few_trials: some participants have fewer than 10"},
        {WarningKind::biasX,
         "bias_x: errors along x lean to one side; their mean absolute value is not scatter alone"},
        {WarningKind::biasY,
         "bias_y: errors along y lean to one side; their mean absolute value is not scatter alone"},
        {WarningKind::beyondRadius, "beyond_radius: # marks lie off the hemisphere"},
        {WarningKind::plannedMarks,
         "planned: # marks are of the observer for planning; nothing was rendered"},
        {WarningKind::untouchedMarks, "out_of_contact: # marks were set without touching anything"},
        {WarningKind::notSimulated, "not_simulated: $"},
        {WarningKind::differencesTooSmall,
         "differences_too_small: the largest difference is below what this observer needs"},
        {WarningKind::runsWithoutEstimate, "runs_without_estimate: # of %"},
        {WarningKind::shownRun,
         "shown: # trials on a device that renders no force: they were shown, not felt"},
        {WarningKind::shownLeftOut,
         "shown_left_out: @ to whom objects were shown, not felt, left out of the group"},
        {WarningKind::shownInGroup, "shown_in_group: @ to whom objects were shown, not felt, are in the "
                                    "group if their answers give a value"},
        {WarningKind::tooFewToTell, "too_few_to_tell: too few answers to tell them from guessing"},
    }};

constexpr bool inOrder() {
    for (std::size_t i = 0; i < kEnglish.size(); ++i)
        if (static_cast<std::size_t>(kEnglish[i].first) != i || kEnglish[i].second.empty())
            return false;
    return true;
}
static_assert(inOrder(), "each kind has its English, in order");

std::string_view englishOf(WarningKind kind) {
    return kind < WarningKind::end ? kEnglish[static_cast<std::size_t>(kind)].second : std::string_view();
}

} // namespace

std::string_view warningToken(WarningKind kind) {
    const std::string_view english = englishOf(kind);
    return english.substr(0, english.find(':'));
}

std::string warningText(const Warning& warning) {
    const std::string count = std::to_string(warning.count);
    std::string text;
    for (const char c : englishOf(warning.kind)) {
        if (c == '#')
            text += count;
        else if (c == '@')
            text += count + (warning.count == 1 ? " participant" : " participants");
        else if (c == '%')
            text += std::to_string(warning.of);
        else if (c == '$')
            text += warning.detail;
        else
            text += c;
    }
    return text;
}

bool hasWarning(const std::vector<Warning>& warnings, WarningKind kind) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const Warning& each) { return each.kind == kind; });
}

} // namespace chiron::psychophysics
