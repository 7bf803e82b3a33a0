// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/study_warning_words.h"

#include "session_report/study_report_text.h"

namespace chiron::session_report {

namespace {

using psychophysics::EstimateMethod;
using psychophysics::Warning;
using psychophysics::WarningKind;

/// Words for warnings about the answers of one run. Empty for other warnings.
QString ofAnswers(const Warning& warning) {
    const int n = warning.count;
    using enum WarningKind;
    switch (warning.kind) {
    case leftOutTrials:
        return Words::tr("%n trial(s) could not be used: the difference or the answer is missing.", nullptr,
                         n);
    case noTrials:
        return Words::tr("There is no scored trial yet, so there is no result.");
    case fewTrials:
        return Words::tr("Only %n trial(s): the interval is wide and depends partly on prior assumptions.",
                         nullptr, n);
    case noDifference:
        return Words::tr("The objects never differed, so it is not known how well they are told apart.");
    case oneLevel:
        return Words::tr("Only one difference was presented: lapses of attention cannot be distinguished "
                         "from a high threshold.");
    case binned:
        return Words::tr("A great many differences were presented; neighbouring ones were grouped.");
    case oneAnswer:
        return Words::tr("The same answer was given every time: it says nothing about what was felt.");
    case allRight:
        return Words::tr("Every answer was right: the threshold may lie below the smallest difference "
                         "presented, but how far below is not known.");
    case chance:
        return Words::tr("The answers are no better than guessing: the threshold may be above the largest "
                         "difference presented.");
    case tooFewToTell:
        return Words::tr("There are too few answers to say whether they are better than guessing. More "
                         "trials would show it.");
    case lapses:
        return Words::tr(
            "More than a tenth of the answers look like guesses even where the difference was easy.");
    case stepFunction:
        return Words::tr("Answers jump from guessing to always right between two neighbouring differences: "
                         "what lies between is not known.");
    case positionBias:
        return Words::tr("Wrong answers name one position much more often than chance would explain.");
    case sealed:
        return Words::tr("The conditions differ in values that the analysis needs: there will be an estimate "
                         "once the study is unblinded.");
    case notRenderedRun:
        return Words::tr("A quick simulation without rendering: the observer knew the values.");
    case shownRun:
        return Words::tr("Shown, not felt: %n trial(s) were done on a device that renders no force.", nullptr,
                         n);
    default:
        return {};
    }
}

/// Words for warnings about the value of one run. Empty for other warnings.
QString ofEstimate(const Warning& warning) {
    using enum WarningKind;
    switch (warning.kind) {
    case priorEdgeLow:
        return Words::tr("The answers do not tell how small the threshold is: the value shown comes from "
                         "prior assumptions.");
    case priorEdgeHigh:
        return Words::tr("The answers do not tell how large the threshold is: the value shown comes from "
                         "prior assumptions.");
    case priorBoundLow:
        return Words::tr("The lower end of the interval comes from prior assumptions, not from the answers.");
    case priorBoundHigh:
        return Words::tr("The upper end of the interval comes from prior assumptions, not from the answers.");
    case poorFit:
        return Words::tr(
            "The curve does not describe the answers well: attention or strategy may have changed.");
    case curvesDisagree:
        return Words::tr("Another curve through the same answers puts the threshold elsewhere: treat the "
                         "value with caution.");
    case noRise:
        return Words::tr(
            "Answers do not get better as the difference grows, so there is no threshold to find.");
    case notMonotone:
        return Words::tr(
            "Answers get worse as the difference grows: check that answers and differences match.");
    case noReference:
    case noSettingReference:
        return Words::tr("The condition has no reference above zero, so no value can be given in its unit.");
    default:
        return {};
    }
}

/// Words for warnings about settings and about stated numbers. Empty for other warnings.
QString ofNumbers(const Warning& warning) {
    const int n = warning.count;
    using enum WarningKind;
    switch (warning.kind) {
    case leftOutSettings:
        return Words::tr("%n setting(s) are not above zero and are left out.", nullptr, n);
    case noSettings:
        return Words::tr("Nothing has been set yet, so there is no result.");
    case fewSettings:
        return Words::tr("With only %n setting(s), the spread of the settings is very uncertain.", nullptr,
                         n);
    case noSpread:
        return Words::tr("All settings are the same: the step of the adjustment may be too coarse.");
    case leftOutNumbers:
        return Words::tr("%n answer(s) are not numbers above zero and are left out.", nullptr, n);
    case noNumbers:
        return Words::tr("No number has been given yet, so there is no result.");
    case fewNumbers:
        return Words::tr("With only %n answer(s), the result is very uncertain.", nullptr, n);
    case oneStimulus:
        return Words::tr("Only one stimulus intensity was presented, so there is no exponent.");
    case fewSubjects:
        return Words::tr(
            "With only %n participant(s) with an exponent, differences between people are very uncertain.",
            nullptr, n);
    default:
        return {};
    }
}

/// Words for warnings about a group. Empty for other warnings.
QString ofGroup(const Warning& warning) {
    const int n = warning.count;
    using enum WarningKind;
    switch (warning.kind) {
    case leftOutParticipants:
        return Words::tr("%n participant(s) are left out: their answers give no value.", nullptr, n);
    case noParticipants:
        return Words::tr("No participant's answers give a value.");
    case oneParticipant:
        return Words::tr("One participant is not a group: there is no interval.");
    case fewParticipants:
        return Words::tr("With only %n participant(s), differences between people are very uncertain.",
                         nullptr, n);
    case heterogeneous:
        return Words::tr("People differ by more than the uncertainty of each: the group's figure says little "
                         "about one person.");
    case withdrawn:
        return Words::tr("%n participant(s) who withdrew are left out.", nullptr, n);
    case simulatedLeftOut:
        return Words::tr("%n simulated participant(s) are left out: the group contains only people.", nullptr,
                         n);
    case simulatedOnly:
        return Words::tr("All participants here are simulated.");
    case notRenderedOfGroup:
        return Words::tr("%n participant(s) were simulated without rendering: the observers knew the values "
                         "and felt nothing.",
                         nullptr, n);
    case shownLeftOut:
        return Words::tr("%n participant(s) are left out of the group: objects were shown to them, not felt.",
                         nullptr, n);
    case shownInGroup:
        // True whether or not the answers give a value.
        return Words::tr("Objects were shown to %n participant(s), not felt. Such runs are included on "
                         "purpose: each counts in the group if its answers give a value.",
                         nullptr, n);
    default:
        return {};
    }
}

/// Words for warnings about an apex or a plan. Empty for other warnings.
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
        return Words::tr("With only %n participant(s), differences between people are very uncertain.",
                         nullptr, n);
    case fewMarks:
        return Words::tr("Some participants have fewer than 10 marks.");
    case biasX:
        return Words::tr("Errors in x lean to one side: the absolute error is not only scatter.");
    case biasY:
        return Words::tr("Errors in y lean to one side: the absolute error is not only scatter.");
    case beyondRadius:
        return Words::tr("%n mark(s) lie off the sphere.", nullptr, n);
    case plannedMarks:
        return Words::tr("%n mark(s) come from a simulated observer: nothing was rendered.", nullptr, n);
    case untouchedMarks:
        return Words::tr("%n mark(s) were set without touching anything.", nullptr, n);
    case notSimulated:
        return Words::tr("This condition cannot be simulated: it needs a procedure and differences.");
    case differencesTooSmall:
        return Words::tr("The largest difference is too small for this observer.");
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
        return Words::tr("Estimated from all orders given, taken together");
    case EstimateMethod::settings:
        return Words::tr("Mean and spread of the settings");
    case EstimateMethod::numbersSaid:
        return Words::tr("Power law fitted to the numbers given");
    case EstimateMethod::apexMarks:
        return Words::tr("Errors of the marks");
    }
    return {};
}

} // namespace chiron::session_report
