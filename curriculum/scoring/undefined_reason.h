// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace chiron::scoring {

/// Why a metric has no value. Each reason has one text that scores store (storedText). A text is never
/// changed, and the text of a reason that is no longer used is kept, so that stored scores keep their
/// meaning.
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
    /// With counts: regions with a lump, regions without one, and how many of each are needed.
    tooFewRegions,
    noCoverage,
    noForceBand,
    nothingPressed,
    nothingPredicted,
    noPrediction,
};
inline constexpr std::size_t kUndefinedReasons = static_cast<std::size_t>(UndefinedReason::noPrediction) + 1;

/// A reason with its counts; counts that it does not use are 0.
struct Undefined {
    UndefinedReason reason = UndefinedReason::noTrials;
    std::array<int, 3> counts{};

    friend bool operator==(const Undefined&, const Undefined&) = default;
};

/// Returns how many counts a reason has: 0 or 3.
std::size_t countsOf(UndefinedReason reason) noexcept;
/// Returns the text for people, English, marked for translation (marked_texts.h), with %1, %2, %3 for its
/// counts.
std::string_view wordsOf(UndefinedReason reason) noexcept;
/// Returns the text that a score stores: English, unambiguous. For a reason without counts it is the fixed
/// text.
std::string storedText(const Undefined& undefined);
/// Returns the reason of a stored text; none if the text is unknown (a score of a later version). The inverse
/// of storedText.
std::optional<Undefined> undefinedOf(std::string_view stored);

} // namespace chiron::scoring
