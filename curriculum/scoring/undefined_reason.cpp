// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/undefined_reason.h"

#include "core/marked_texts.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace chiron::scoring {

namespace {

using enum UndefinedReason;

/// A reason with the text that scores store, which is never changed ("#" stands for a count), and the text
/// for people (%1 for the first count).
struct ReasonRow {
    UndefinedReason reason;
    std::string_view stored;
    std::string_view words;
};

// clang-format off
constexpr auto kReasons = std::to_array<ReasonRow>({
    {noForces, "the trace has no forces", QT_TRANSLATE_NOOP("Metrics", "the recording has no forces")},
    {noTrials, "no trials", QT_TRANSLATE_NOOP("Metrics", "no trials")},
    {noneFinished, "no trial was finished", QT_TRANSLATE_NOOP("Metrics", "no trial was finished")},
    {notFinished, "the trial was not finished", QT_TRANSLATE_NOOP("Metrics", "the trial was not finished")},
    {noSamples, "no samples", QT_TRANSLATE_NOOP("Metrics", "no samples")},
    {tooFewSamples, "fewer than two samples", QT_TRANSLATE_NOOP("Metrics", "fewer than two samples")},
    {tooFewPositions, "fewer than two positions", QT_TRANSLATE_NOOP("Metrics", "fewer than two positions")},
    {noContact, "no contact", QT_TRANSLATE_NOOP("Metrics", "no contact")},
    {endsTooNear, "start and end are less than 5 mm apart", QT_TRANSLATE_NOOP("Metrics", "start and end are less than 5 mm apart")},
    {neitherMovementNorContact, "neither movement nor contact", QT_TRANSLATE_NOOP("Metrics", "neither movement nor contact")},
    {noMovement, "no movement", QT_TRANSLATE_NOOP("Metrics", "no movement")},
    {noSubMovement, "no sub-movement of 100 ms", QT_TRANSLATE_NOOP("Metrics", "no sub-movement of at least 100 ms")},
    {noSpectrum, "speed has no spectrum up to 10 Hz", QT_TRANSLATE_NOOP("Metrics", "speed has no spectrum up to 10 Hz")},
    {tooFewSpeeds, "fewer than three speed samples", QT_TRANSLATE_NOOP("Metrics", "fewer than three speed samples")},
    {noJerk, "no jerk: speed changes evenly", QT_TRANSLATE_NOOP("Metrics", "no jerk: speed changes evenly")},
    {needsTwoTrials, "needs two trials or more", QT_TRANSLATE_NOOP("Metrics", "needs two trials or more")},
    {oneTrialHasNoChance, "one trial alone has no chance level", QT_TRANSLATE_NOOP("Metrics", "there is no chance level for a single trial")},
    {noPosition, "no position to score", QT_TRANSLATE_NOOP("Metrics", "no position to score")},
    {apexUnknown, "the apex's true place is not known", QT_TRANSLATE_NOOP("Metrics", "the true position of the apex is not known")},
    {noInsertionData, "the trace has no insertion data", QT_TRANSLATE_NOOP("Metrics", "the recording has no insertion data")},
    {noProcedure, "the trace has no procedure", QT_TRANSLATE_NOOP("Metrics", "the recording has no procedure")},
    {noTorques, "the trace has no torques", QT_TRANSLATE_NOOP("Metrics", "the recording has no torques")},
    {neverInUrethra, "the tip was never in the urethra", QT_TRANSLATE_NOOP("Metrics", "the tip was never in the urethra")},
    {neverAtBend, "the tip was never at the bend", QT_TRANSLATE_NOOP("Metrics", "the tip was never at the bend")},
    {noLandmarks, "the level has no landmarks", QT_TRANSLATE_NOOP("Metrics", "the level has no landmarks")},
    {inspectionNotReached, "the inspection was not reached", QT_TRANSLATE_NOOP("Metrics", "the inspection was not reached")},
    {noTubeData, "the trace has no data of a tube", QT_TRANSLATE_NOOP("Metrics", "the recording has no tube data")},
    {noSuchTarget, "the task has no such target", QT_TRANSLATE_NOOP("Metrics", "the task has no such target")},
    {tensionNeverHeld, "the tension was never held", QT_TRANSLATE_NOOP("Metrics", "the tension was never held")},
    {noSqueeze, "the trace has no squeeze", QT_TRANSLATE_NOOP("Metrics", "the recording has no squeeze")},
    {noSqueezeLimit, "the trace has no squeeze limit", QT_TRANSLATE_NOOP("Metrics", "the recording has no squeeze limit")},
    {noObjectsAndTarget, "the trace has no objects and target", QT_TRANSLATE_NOOP("Metrics", "the recording has neither objects nor a target")},
    {noWeighing, "no weighing was asked for", QT_TRANSLATE_NOOP("Metrics", "the level asks for no weighing")},
    {noLumpsAndArea, "the trace has no lumps and search area", QT_TRANSLATE_NOOP("Metrics", "the recording has neither lumps nor a search area")},
    {noReports, "the trace has no reports", QT_TRANSLATE_NOOP("Metrics", "the recording has no reports")},
    {lostReports, "the trace lost reports", QT_TRANSLATE_NOOP("Metrics", "reports are missing from the recording")},
    {noLumpThere, "no lump was there", QT_TRANSLATE_NOOP("Metrics", "there was no lump")},
    {noLumpFound, "no lump was found", QT_TRANSLATE_NOOP("Metrics", "no lump was found")},
    {noConfidence, "nobody said how sure a finding is", QT_TRANSLATE_NOOP("Metrics", "no finding has a confidence rating")},
    {noSizeSaid, "of no lump that was found the size was said", QT_TRANSLATE_NOOP("Metrics", "no lump found was given a size")},
    {noSizeAsked, "the level asks for no size", QT_TRANSLATE_NOOP("Metrics", "the level asks for no size")},
    {noHardnessAsked, "the level asks for no hardness", QT_TRANSLATE_NOOP("Metrics", "the level asks for no hardness")},
    {tooFewHardnessOfATrial, "fewer than two lumps of a trial were found and their hardness said", QT_TRANSLATE_NOOP("Metrics", "in no trial were two lumps found and given a hardness")},
    {tooFewHardness, "fewer than two lumps were found and their hardness said", QT_TRANSLATE_NOOP("Metrics", "fewer than two lumps were found and given a hardness")},
    {equallyHard, "the lumps that were found are equally hard", QT_TRANSLATE_NOOP("Metrics", "the lumps that were found are equally hard")},
    {noUnequalPair, "no two lumps of different hardness were found and rated", QT_TRANSLATE_NOOP("Metrics", "no two lumps of different hardness were found and rated")},
    {tooFewLumps, "fewer than two lumps were there", QT_TRANSLATE_NOOP("Metrics", "there were fewer than two lumps")},
    {tooFewRegions, "only # regions with a lump and # without: # of each are needed", QT_TRANSLATE_NOOP("Metrics", "only %1 regions with a lump and %2 without: %3 of each are needed")},
    {noCoverage, "the trace has no coverage", QT_TRANSLATE_NOOP("Metrics", "the recording has no coverage data")},
    {noForceBand, "the trace has no force band", QT_TRANSLATE_NOOP("Metrics", "the recording has no force band")},
    {nothingPressed, "nothing was pressed", QT_TRANSLATE_NOOP("Metrics", "nothing was pressed")},
    {nothingPredicted, "nothing was touched, so nothing was predicted", QT_TRANSLATE_NOOP("Metrics", "nothing was touched, so nothing was predicted")},
    {noPrediction, "the trace has no prediction", QT_TRANSLATE_NOOP("Metrics", "the recording has no prediction")},
});
// clang-format on
static_assert(kReasons.size() == kUndefinedReasons);
static_assert(
    [] {
        for (std::size_t i = 0; i < kReasons.size(); ++i)
            if (kReasons[i].reason != static_cast<UndefinedReason>(i))
                return false;
        return true;
    }(),
    "in the enumeration's order");

constexpr std::string_view patternOf(UndefinedReason reason) noexcept {
    return kReasons[static_cast<std::size_t>(reason)].stored;
}

/// Returns the counts in `stored` if it matches the pattern with a number for each "#".
std::optional<std::array<int, 3>> matched(std::string_view pattern, std::string_view stored) {
    std::array<int, 3> counts{};
    std::size_t count = 0;
    for (const char wanted : pattern) {
        if (wanted != '#') {
            if (stored.empty() || stored.front() != wanted)
                return std::nullopt;
            stored.remove_prefix(1);
            continue;
        }
        const auto [end, error] =
            std::from_chars(stored.data(), stored.data() + stored.size(), counts[count++]);
        if (error != std::errc{} || counts[count - 1] < 0)
            return std::nullopt;
        stored.remove_prefix(static_cast<std::size_t>(end - stored.data()));
    }
    return stored.empty() ? std::optional(counts) : std::nullopt;
}

} // namespace

std::size_t countsOf(UndefinedReason reason) noexcept {
    const std::string_view pattern = patternOf(reason);
    return static_cast<std::size_t>(std::count(pattern.begin(), pattern.end(), '#'));
}

std::string_view wordsOf(UndefinedReason reason) noexcept {
    return kReasons[static_cast<std::size_t>(reason)].words;
}

std::string storedText(const Undefined& undefined) {
    std::string text;
    std::size_t count = 0;
    for (const char c : patternOf(undefined.reason)) {
        if (c == '#')
            text += std::to_string(undefined.counts[count++]);
        else
            text += c;
    }
    return text;
}

std::optional<Undefined> undefinedOf(std::string_view stored) {
    for (const ReasonRow& row : kReasons)
        if (const auto counts = matched(row.stored, stored))
            return Undefined{row.reason, *counts};
    return std::nullopt;
}

} // namespace chiron::scoring
