// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace chiron::scoring {

/// Why a metric has no value. Each has one stored text (storedText), which scores keep: a text is never changed, and of a reason that is
/// not used any more it stays, so that stored scores keep their meaning.
enum class UndefinedReason : std::uint8_t {
    noForces,
    noTrials,
    noneFinished,
    notFinished,
    noSamples,
    tooFewSamples,
    tooFewPositions,
    noContact,
    endsTooNear,
    neitherMovementNorContact,
    noMovement,
    noSubMovement,
    noSpectrum,
    tooFewSpeeds,
    noJerk,
    needsTwoTrials,
    oneTrialHasNoChance,
    noPosition,
    apexUnknown,
    noInsertionData,
    noProcedure,
    noTorques,
    neverInUrethra,
    neverAtBend,
    noLandmarks,
    inspectionNotReached,
    noTubeData,
    noSuchTarget,
    tensionNeverHeld,
    noSqueeze,
    noSqueezeLimit,
    noObjectsAndTarget,
    noWeighing,
    noLumpsAndArea,
    noReports,
    lostReports,
    noLumpThere,
    noLumpFound,
    noConfidence,
    noSizeSaid,
    noSizeAsked,
    noHardnessAsked,
    tooFewHardnessOfATrial,
    tooFewHardness,
    equallyHard,
    noUnequalPair,
    tooFewLumps,
    tooFewRegions, ///< with counts: regions with a lump, without one, how many of each are needed
    noCoverage,
    noForceBand,
    nothingPressed,
    nothingPredicted,
    noPrediction,
};
inline constexpr std::size_t kUndefinedReasons = static_cast<std::size_t>(UndefinedReason::noPrediction) + 1;

/// A reason with its counts; those that it does not tell are 0.
struct Undefined {
    UndefinedReason reason = UndefinedReason::noTrials;
    std::array<int, 3> counts{};

    friend bool operator==(const Undefined&, const Undefined&) = default;
};

/// How many counts a reason tells: 0 or 3.
std::size_t countsOf(UndefinedReason reason) noexcept;
/// What people read, English, marked for translation (marked_texts.h), with %1, %2, %3 for its counts.
std::string_view wordsOf(UndefinedReason reason) noexcept;
/// What a score keeps: English, unambiguous. A reason without counts is its text alone.
std::string storedText(const Undefined& undefined);
/// The reason of a stored text; nothing where it is none of ours (a score of a later version). The inverse of storedText.
std::optional<Undefined> undefinedOf(std::string_view stored);

} // namespace chiron::scoring
