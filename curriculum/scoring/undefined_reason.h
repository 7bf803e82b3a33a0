// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/marked_texts.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace chiron::scoring {

/// Why a metric has no value: one constant for each reason. Those of metrics that several exercises share are
/// in `reasons` below; those of one exercise stand in its folder, in the same namespace. Two reasons are the
/// same if their stored texts are.
struct UndefinedReason {
    /// The text that scores store, English, "#" for a count. It is never changed, and that of a reason that
    /// is no longer used is kept, so that stored scores keep their meaning.
    std::string_view stored;
    /// The text for people, English, marked for translation (marked_texts.h), %1 for the first count.
    std::string_view words;

    friend constexpr bool operator==(const UndefinedReason& a, const UndefinedReason& b) noexcept {
        return a.stored == b.stored;
    }
};

// clang-format off
namespace reasons {
inline constexpr UndefinedReason kNoForces{"the trace has no forces", QT_TRANSLATE_NOOP("Metrics", "the recording has no forces")};
inline constexpr UndefinedReason kNoTrials{"no trials", QT_TRANSLATE_NOOP("Metrics", "no trials")};
inline constexpr UndefinedReason kNoneFinished{"no trial was finished", QT_TRANSLATE_NOOP("Metrics", "no trial was finished")};
inline constexpr UndefinedReason kNotFinished{"the trial was not finished", QT_TRANSLATE_NOOP("Metrics", "the trial was not finished")};
inline constexpr UndefinedReason kNoSamples{"no samples", QT_TRANSLATE_NOOP("Metrics", "no samples")};
inline constexpr UndefinedReason kTooFewSamples{"fewer than two samples", QT_TRANSLATE_NOOP("Metrics", "fewer than two samples")};
inline constexpr UndefinedReason kTooFewPositions{"fewer than two positions", QT_TRANSLATE_NOOP("Metrics", "fewer than two positions")};
inline constexpr UndefinedReason kNoContact{"no contact", QT_TRANSLATE_NOOP("Metrics", "no contact")};
inline constexpr UndefinedReason kEndsTooNear{"start and end are less than 5 mm apart", QT_TRANSLATE_NOOP("Metrics", "start and end are less than 5 mm apart")};
inline constexpr UndefinedReason kNeitherMovementNorContact{"neither movement nor contact", QT_TRANSLATE_NOOP("Metrics", "neither movement nor contact")};
inline constexpr UndefinedReason kNoMovement{"no movement", QT_TRANSLATE_NOOP("Metrics", "no movement")};
inline constexpr UndefinedReason kNoSubMovement{"no sub-movement of 100 ms", QT_TRANSLATE_NOOP("Metrics", "no sub-movement of at least 100 ms")};
inline constexpr UndefinedReason kNoSpectrum{"speed has no spectrum up to 10 Hz", QT_TRANSLATE_NOOP("Metrics", "speed has no spectrum up to 10 Hz")};
inline constexpr UndefinedReason kTooFewSpeeds{"fewer than three speed samples", QT_TRANSLATE_NOOP("Metrics", "fewer than three speed samples")};
inline constexpr UndefinedReason kNoJerk{"no jerk: speed changes evenly", QT_TRANSLATE_NOOP("Metrics", "no jerk: speed changes evenly")};
inline constexpr UndefinedReason kNoPosition{"no position to score", QT_TRANSLATE_NOOP("Metrics", "no position to score")};
inline constexpr UndefinedReason kNoProcedure{"the trace has no procedure", QT_TRANSLATE_NOOP("Metrics", "the recording has no procedure")};
inline constexpr UndefinedReason kNoTorques{"the trace has no torques", QT_TRANSLATE_NOOP("Metrics", "the recording has no torques")};
inline constexpr UndefinedReason kNoSuchTarget{"the task has no such target", QT_TRANSLATE_NOOP("Metrics", "the task has no such target")};
inline constexpr UndefinedReason kNothingPredicted{"nothing was touched, so nothing was predicted", QT_TRANSLATE_NOOP("Metrics", "nothing was touched, so nothing was predicted")};
inline constexpr UndefinedReason kNoPrediction{"the trace has no prediction", QT_TRANSLATE_NOOP("Metrics", "the recording has no prediction")};
} // namespace reasons
// clang-format on

/// The reasons of `reasons` above.
inline constexpr std::array kSharedReasons{reasons::kNoForces,        reasons::kNoTrials,
                                           reasons::kNoneFinished,    reasons::kNotFinished,
                                           reasons::kNoSamples,       reasons::kTooFewSamples,
                                           reasons::kTooFewPositions, reasons::kNoContact,
                                           reasons::kEndsTooNear,     reasons::kNeitherMovementNorContact,
                                           reasons::kNoMovement,      reasons::kNoSubMovement,
                                           reasons::kNoSpectrum,      reasons::kTooFewSpeeds,
                                           reasons::kNoJerk,          reasons::kNoPosition,
                                           reasons::kNoProcedure,     reasons::kNoTorques,
                                           reasons::kNoSuchTarget,    reasons::kNothingPredicted,
                                           reasons::kNoPrediction};

/// Every reason, shared ones and those of exercises. metric_catalogue.cpp lists them.
std::span<const UndefinedReason> undefinedReasons();

/// A reason with its counts; counts that it does not use are 0.
struct Undefined {
    UndefinedReason reason = reasons::kNoTrials;
    std::array<int, 3> counts{};

    friend bool operator==(const Undefined&, const Undefined&) = default;
};

/// Returns how many counts a reason has: 0 or 3.
std::size_t countsOf(const UndefinedReason& reason) noexcept;
/// Returns the text that a score stores: English, unambiguous. For a reason without counts it is the fixed
/// text.
std::string storedText(const Undefined& undefined);
/// Returns the reason of a stored text; none if the text is unknown (a score of a later version). The inverse
/// of storedText.
std::optional<Undefined> undefinedOf(std::string_view stored);

} // namespace chiron::scoring
