// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/study_warning_words.h"

#include "session_report/study_report_text.h"

namespace chiron::session_report {

namespace {

using psychophysics::EstimateMethod;
using psychophysics::Warning;
using psychophysics::WarningKind;

/// Of what was answered in one run. Empty for another kind.
QString ofAnswers(const Warning& warning) {
    const int n = warning.count;
    using enum WarningKind;
    switch (warning.kind) {
    case leftOutTrials:
        return Words::tr("%n trial(s) could not be used: the difference or the answer is missing.", nullptr, n);
    case noTrials:
        return Words::tr("There is no scored trial yet, so nothing can be said.");
    case fewTrials:
        return Words::tr("Only %n trial(s): the interval is wide and rests partly on what was assumed beforehand.", nullptr, n);
    case noDifference:
        return Words::tr("The objects never differed, so nothing can be said about telling them apart.");
    case oneLevel:
        return Words::tr("Only one difference was presented: slips of attention cannot be told from a high threshold.");
    case binned:
        return Words::tr("Very many different differences were presented; neighbouring ones were put together.");
    case oneAnswer:
        return Words::tr("The same answer was given every time: it says nothing about what was felt.");
    case allRight:
        return Words::tr("Every answer was right: the threshold is below the smallest difference, how far is not known.");
    case chance:
        return Words::tr("No better than guessing: the threshold may be above the largest difference presented.");
    case lapses:
        return Words::tr("More than a tenth of the answers look like guesses even where the difference was easy.");
    case stepFunction:
        return Words::tr("Answers jump from guessing to always right between two neighbouring differences: what lies between is not known.");
    case positionBias:
        return Words::tr("Wrong answers fall on one place much more often than chance allows.");
    case sealed:
        return Words::tr("Conditions differ in what an analysis needs to know: there is an estimate once the study is unblinded.");
    case notRenderedRun:
        return Words::tr("A quick simulation without rendering: the observer was told the values.");
    case shownRun:
        return Words::tr("Shown, not felt: %n trial(s) were done on a device that renders no force.", nullptr, n);
    default:
        return {};
    }
}

/// Of the value of one run. Empty for another kind.
QString ofEstimate(const Warning& warning) {
    using enum WarningKind;
    switch (warning.kind) {
    case priorEdgeLow:
        return Words::tr("The answers do not tell how small the threshold is: the value shown is what was assumed beforehand.");
    case priorEdgeHigh:
        return Words::tr("The answers do not tell how large the threshold is: the value shown is what was assumed beforehand.");
    case priorBoundLow:
        return Words::tr("The lower end of the interval comes from what was assumed beforehand, not from the answers.");
    case priorBoundHigh:
        return Words::tr("The upper end of the interval comes from what was assumed beforehand, not from the answers.");
    case poorFit:
        return Words::tr("The curve does not describe the answers well: attention or strategy may have changed.");
    case curvesDisagree:
        return Words::tr("Another curve through the same answers puts the threshold elsewhere: take the value with care.");
    case noRise:
        return Words::tr("Answers do not get better as the difference grows, so there is no threshold to find.");
    case notMonotone:
        return Words::tr("Answers get worse as the difference grows: do differences and answers belong together?");
    case noReference:
    case noSettingReference:
        return Words::tr("The condition has no reference above zero, so nothing can be given in its unit.");
    default:
        return {};
    }
}

/// Of settings, and of numbers said. Empty for another kind.
QString ofNumbers(const Warning& warning) {
    const int n = warning.count;
    using enum WarningKind;
    switch (warning.kind) {
    case leftOutSettings:
        return Words::tr("%n setting(s) are not above zero and are left out.", nullptr, n);
    case noSettings:
        return Words::tr("Nothing has been set yet, so nothing can be said.");
    case fewSettings:
        return Words::tr("Only %n setting(s): how much they scatter is hardly known.", nullptr, n);
    case noSpread:
        return Words::tr("All settings are the same: the step of the adjustment may be too coarse.");
    case leftOutNumbers:
        return Words::tr("%n answer(s) are not numbers above zero and are left out.", nullptr, n);
    case noNumbers:
        return Words::tr("No number has been said yet, so nothing can be said.");
    case fewNumbers:
        return Words::tr("Only %n answer(s): the result is hardly known.", nullptr, n);
    case oneStimulus:
        return Words::tr("Only one strength was presented, so there is no exponent.");
    case fewSubjects:
        return Words::tr("Only %n participant(s) with an exponent: how people differ is hardly known.", nullptr, n);
    default:
        return {};
    }
}

/// Of a group. Empty for another kind.
QString ofGroup(const Warning& warning) {
    const int n = warning.count;
    using enum WarningKind;
    switch (warning.kind) {
    case leftOutParticipants:
        return Words::tr("%n participant(s) are left out: their answers give no value.", nullptr, n);
    case noParticipants:
        return Words::tr("Nobody's answers give a value.");
    case oneParticipant:
        return Words::tr("One participant is not a group: there is no interval.");
    case fewParticipants:
        return Words::tr("Only %n participant(s): how people differ is hardly known.", nullptr, n);
    case heterogeneous:
        return Words::tr("People differ by more than the uncertainty of each: the group's figure says little about one person.");
    case withdrawn:
        return Words::tr("%n participant(s) who withdrew are left out.", nullptr, n);
    case simulatedLeftOut:
        return Words::tr("%n simulated participant(s) are left out: the group is of people.", nullptr, n);
    case simulatedOnly:
        return Words::tr("The group is of simulated participants alone.");
    case notRenderedOfGroup:
        return Words::tr("%n participant(s) of the group were simulated without rendering: told the values, nothing was felt.", nullptr, n);
    case shownLeftOut:
        return Words::tr("%n participant(s) are left out of the group: objects were shown to them, not felt.", nullptr, n);
    case shownInGroup:
        return Words::tr("The group holds %n participant(s) to whom objects were shown, not felt.", nullptr, n);
    default:
        return {};
    }
}

/// Of an apex or a plan. Empty for another kind.
QString ofApexOrPlan(const Warning& warning) {
    const int n = warning.count;
    using enum WarningKind;
    switch (warning.kind) {
    case noRadius:
        return Words::tr("The sphere has no radius above zero.");
    case leftOutMarks:
        return Words::tr("%n trial(s) have no mark and are left out.", nullptr, n);
    case noMarks:
        return Words::tr("There is no mark to summarise.");
    case fewMarkers:
        return Words::tr("Only %n participant(s): how people differ is hardly known.", nullptr, n);
    case fewMarks:
        return Words::tr("Some participants have fewer than 10 marks.");
    case biasX:
        return Words::tr("Errors in x lean to one side: the absolute error is not scatter alone.");
    case biasY:
        return Words::tr("Errors in y lean to one side: the absolute error is not scatter alone.");
    case beyondRadius:
        return Words::tr("%n mark(s) lie off the sphere.", nullptr, n);
    case plannedMarks:
        return Words::tr("%n mark(s) are of the observer for planning: nothing was rendered.", nullptr, n);
    case untouchedMarks:
        return Words::tr("%n mark(s) were set without touching anything.", nullptr, n);
    case notSimulated:
        return Words::tr("This condition cannot be simulated: it needs a procedure and differences.");
    case differencesTooSmall:
        return Words::tr("The largest difference is below what this observer needs.");
    case runsWithoutEstimate:
        return Words::tr("%n of %1 simulated run(s) gave no value.", nullptr, n).arg(warning.of);
    default:
        return {};
    }
}

} // namespace

QString warningWords(const Warning& warning) {
    for (const auto part : {ofAnswers, ofEstimate, ofNumbers, ofGroup, ofApexOrPlan})
        if (const QString words = part(warning); !words.isEmpty())
            return words;
    return {};
}

QString methodWords(EstimateMethod method) {
    switch (method) {
    case EstimateMethod::none:
        return {};
    case EstimateMethod::observer:
        return Words::tr("Estimated from all answers together, right and wrong");
    case EstimateMethod::observerOfOrders:
        return Words::tr("Estimated from all orders said together");
    case EstimateMethod::settings:
        return Words::tr("Mean and spread of what was set");
    case EstimateMethod::numbersSaid:
        return Words::tr("A power law through the numbers said");
    case EstimateMethod::apexMarks:
        return Words::tr("Errors of the marks");
    }
    return {};
}

} // namespace chiron::session_report
