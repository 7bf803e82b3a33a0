// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::psychophysics {

/// What a reader of an estimate must know. Screens and reports show each in a person's words and language
/// (session_report/study_warning_words); data contain the token and English. A new kind is inserted before
/// `end` and needs both: the compiler demands the English text, the test of the translations the words.
enum class WarningKind : std::uint8_t {
    // One run of comparisons.
    leftOutTrials,
    noTrials,
    fewTrials,
    noDifference,
    oneLevel,
    binned,
    oneAnswer,
    allRight,
    chance,
    priorEdgeLow,
    priorEdgeHigh, ///< the answers do not determine this end: the estimate comes from the
                   ///< prior
    priorBoundLow,
    priorBoundHigh, ///< the prior determines where the interval ends
    lapses,
    stepFunction,
    positionBias,
    poorFit,
    curvesDisagree,
    noRise,
    notMonotone,
    noReference,
    // Settings, and numbers given.
    leftOutSettings,
    noSettings,
    fewSettings,
    noSpread,
    noSettingReference,
    leftOutNumbers,
    noNumbers,
    fewNumbers,
    oneStimulus,
    fewSubjects,
    // A group.
    leftOutParticipants,
    noParticipants,
    oneParticipant,
    fewParticipants,
    heterogeneous,
    withdrawn,
    simulatedLeftOut,
    simulatedOnly,
    notRenderedOfGroup,
    notRenderedRun,
    sealed,
    // The apex.
    noRadius,
    leftOutMarks,
    noMarks,
    fewMarkers,
    fewMarks,
    biasX,
    biasY,
    beyondRadius,
    plannedMarks,
    untouchedMarks,
    // A plan.
    notSimulated,
    differencesTooSmall,
    runsWithoutEstimate,
    // Force was shown, not felt.
    shownRun,
    shownLeftOut,
    shownInGroup,
    tooFewToTell, ///< of a run: guessing is not refuted, and neither is a clear advantage over it
    end,          ///< not a warning: the number of kinds
};

struct Warning {
    WarningKind kind;
    int count = 0;        ///< the number that a counting kind reports
    int of = 0;           ///< total, for runsWithoutEstimate
    std::string detail{}; ///< English: the reason, for notSimulated

    friend bool operator==(const Warning&, const Warning&) = default;
};

/// Returns the name of a warning in data: "left_out". Several kinds share a name if they differ only in what
/// they refer to. The names are stable.
std::string_view warningToken(WarningKind kind);
/// Returns the text as in data and on the command line: "left_out: 3 trials have no usable difference or
/// answer and were left out".
std::string warningText(const Warning& warning);

/// Returns whether `warnings` contains this kind.
bool hasWarning(const std::vector<Warning>& warnings, WarningKind kind);

} // namespace chiron::psychophysics
