// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/undefined_reason.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace chiron::scoring {

namespace {

using enum UndefinedReason;

/// Stored texts; "#" stands for a count.
constexpr auto kStored = std::to_array<std::pair<UndefinedReason, std::string_view>>({
    {noForces, "the trace has no forces"},
    {noTrials, "no trials"},
    {noneFinished, "no trial was finished"},
    {notFinished, "the trial was not finished"},
    {noSamples, "no samples"},
    {tooFewSamples, "fewer than two samples"},
    {tooFewPositions, "fewer than two positions"},
    {noContact, "no contact"},
    {endsTooNear, "start and end are less than 5 mm apart"},
    {neitherMovementNorContact, "neither movement nor contact"},
    {noMovement, "no movement"},
    {noSubMovement, "no sub-movement of 100 ms"},
    {noSpectrum, "speed has no spectrum up to 10 Hz"},
    {tooFewSpeeds, "fewer than three speed samples"},
    {noJerk, "no jerk: speed changes evenly"},
    {needsTwoTrials, "needs two trials or more"},
    {oneTrialHasNoChance, "one trial alone has no chance level"},
    {noPosition, "no position to score"},
    {apexUnknown, "the apex's true place is not known"},
    {noInsertionData, "the trace has no insertion data"},
    {noProcedure, "the trace has no procedure"},
    {noTorques, "the trace has no torques"},
    {neverInUrethra, "the tip was never in the urethra"},
    {neverAtBend, "the tip was never at the bend"},
    {noLandmarks, "the level has no landmarks"},
    {inspectionNotReached, "the inspection was not reached"},
    {noTubeData, "the trace has no data of a tube"},
    {noSuchTarget, "the task has no such target"},
    {tensionNeverHeld, "the tension was never held"},
    {noSqueeze, "the trace has no squeeze"},
    {noSqueezeLimit, "the trace has no squeeze limit"},
    {noObjectsAndTarget, "the trace has no objects and target"},
    {noWeighing, "no weighing was asked for"},
    {noLumpsAndArea, "the trace has no lumps and search area"},
    {noReports, "the trace has no reports"},
    {lostReports, "the trace lost reports"},
    {noLumpThere, "no lump was there"},
    {noLumpFound, "no lump was found"},
    {noConfidence, "nobody said how sure a finding is"},
    {noSizeSaid, "of no lump that was found the size was said"},
    {noSizeAsked, "the level asks for no size"},
    {noHardnessAsked, "the level asks for no hardness"},
    {tooFewHardnessOfATrial, "fewer than two lumps of a trial were found and their hardness said"},
    {tooFewHardness, "fewer than two lumps were found and their hardness said"},
    {equallyHard, "the lumps that were found are equally hard"},
    {noUnequalPair, "no two lumps of different hardness were found and rated"},
    {tooFewLumps, "fewer than two lumps were there"},
    {tooFewRegions, "only # regions with a lump and # without: # of each are needed"},
    {noCoverage, "the trace has no coverage"},
    {noForceBand, "the trace has no force band"},
    {nothingPressed, "nothing was pressed"},
    {nothingPredicted, "nothing was touched, so nothing was predicted"},
    {noPrediction, "the trace has no prediction"},
});
static_assert(kStored.size() == kUndefinedReasons);
static_assert([] {
    for (std::size_t i = 0; i < kStored.size(); ++i)
        if (kStored[i].first != static_cast<UndefinedReason>(i))
            return false;
    return true;
}(), "in the enumeration's order");

constexpr std::string_view patternOf(UndefinedReason reason) noexcept { return kStored[static_cast<std::size_t>(reason)].second; }

/// The counts of `stored` where it is the pattern with a number for each "#".
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
        const auto [end, error] = std::from_chars(stored.data(), stored.data() + stored.size(), counts[count++]);
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
    for (const auto& [reason, pattern] : kStored)
        if (const auto counts = matched(pattern, stored))
            return Undefined{reason, *counts};
    return std::nullopt;
}

} // namespace chiron::scoring
