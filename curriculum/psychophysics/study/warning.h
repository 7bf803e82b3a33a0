// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::psychophysics {

/// What a reader of an estimate must know. Screens and reports put each into a person's words and language
/// (session_report/study_warning_words); data keep the token and English. A new kind goes before `end` and gets both: the compiler asks
/// for the English, the test of the translations for the words.
enum class WarningKind : std::uint8_t {
    // One run of comparisons.
    leftOutTrials, noTrials, fewTrials, noDifference, oneLevel, binned, oneAnswer, allRight, chance,
    priorEdgeLow, priorEdgeHigh,   ///< the answers say nothing at this end: the estimate is the prior's
    priorBoundLow, priorBoundHigh, ///< the interval ends there by the prior
    lapses, stepFunction, positionBias, poorFit, curvesDisagree, noRise, notMonotone, noReference,
    // Settings, and numbers said.
    leftOutSettings, noSettings, fewSettings, noSpread, noSettingReference,
    leftOutNumbers, noNumbers, fewNumbers, oneStimulus, fewSubjects,
    // A group.
    leftOutParticipants, noParticipants, oneParticipant, fewParticipants, heterogeneous,
    withdrawn, simulatedLeftOut, simulatedOnly, notRenderedOfGroup, notRenderedRun, sealed,
    // The apex.
    noRadius, leftOutMarks, noMarks, fewMarkers, fewMarks, biasX, biasY, beyondRadius, plannedMarks, untouchedMarks,
    // A plan.
    notSimulated, differencesTooSmall, runsWithoutEstimate,
    // Shown is not felt.
    shownRun, shownLeftOut, shownInGroup,
    end, ///< no warning: how many there are
};

struct Warning {
    WarningKind kind;
    int count = 0;      ///< how many, where the kind counts
    int of = 0;         ///< of how many: runsWithoutEstimate
    std::string detail{}; ///< English: why, of notSimulated

    friend bool operator==(const Warning&, const Warning&) = default;
};

/// What a warning is called in data: "left_out". Several kinds share one where they are of different things. Stable.
std::string_view warningToken(WarningKind kind);
/// As data and the command line have it: "left_out: 3 trials have no usable difference or answer and were left out".
std::string warningText(const Warning& warning);

/// Kinds of `warnings`, to ask what is among them.
bool hasWarning(const std::vector<Warning>& warnings, WarningKind kind);

} // namespace chiron::psychophysics
