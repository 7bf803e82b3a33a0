// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base_mounting.h"
#include "core/exercise_parameters.h"
#include "scoring/score_card.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace chiron::catalogue {

/// A text by language ("en" is always present), UTF-8.
using Translated = std::map<std::string, std::string>;

/// Returns the text in `language` ("de", "el", ...) or, if it is missing, in English.
const std::string& textIn(const Translated& text, const std::string& language);

using core::ExerciseParameters;

struct MetricChoice {
    std::string id;
    int version = 1;
};

/// How a level that needs a device with force is offered on a device without it: these cues show the force
/// instead of rendering it, and the scores form a series of their own.
struct ShownForceVariant {
    std::vector<std::string> cues;
    Translated note;
};

struct ExerciseLevel {
    std::string id; ///< file name without .json
    int number = 1; ///< --level N, from 1
    Translated title;
    Translated goal; ///< the objective in one sentence; may be empty
    Translated objective;
    Translated measured; ///< what is measured, in words
    /// Which of object, tool, arrow, bars, numbers, plots, sound, coverage are on.
    std::vector<std::string> cues;
    bool feedback = false;   ///< after an answer the scene shows how good it was: for training, not for
                             ///< assessment
    bool needsForce = false; ///< no visible object: needs a device that renders force
    std::optional<ShownForceVariant> shownForce;
    ExerciseParameters parameters;
    /// Where the base of each instrument's device stands relative to where the exercise puts it, in the order
    /// of the instruments. Instruments that are left out stand where the exercise puts them. A person or a
    /// command line may mount them differently.
    std::vector<core::BaseMounting> mounting;
    std::vector<MetricChoice> metrics; ///< in display order
    std::vector<scoring::Gate> gates;
    std::string exercise; ///< id of the exercise
    int exerciseVersion = 1;
    /// Canonical JSON of the level with every default filled in: what a session stores.
    std::string resolvedJson;
    std::string resolvedSha256; ///< SHA-256 of resolvedJson, lower-case hex
};

/// Explains something that is drawn in the scene.
struct LegendLine {
    std::string mark; ///< which drawn mark; explained on levels whose scene may draw it
    Translated text;
};

/// The places in Advice::moment. Every such text has the last one.
inline constexpr const char* kMomentValue = "{value}"; ///< the quantity there, with its unit
inline constexpr const char* kMomentEvent = "{event}"; ///< what happened there, as a clause with a capital
inline constexpr const char* kMomentWhere = "{where}"; ///< "in trial 2, 0:05.0 after it began"

/// What to do differently if the gate of a metric was not met.
struct Advice {
    std::string metric;
    Translated text;
    /// What the recording shows of the moment at which it was worst, with places to fill in (kMoment...);
    /// empty if the exercise has no such sentence.
    Translated moment{};

    bool operator==(const Advice&) const = default;
};

struct Exercise {
    std::string id;
    int version = 1;
    Translated title;
    Translated objective;
    /// In the order written: advice on a cause of other misses comes before advice on those misses. Each
    /// metric occurs at most once; some may have no advice.
    std::vector<Advice> advice;
    std::vector<LegendLine> legend;    ///< in display order
    std::vector<ExerciseLevel> levels; ///< by number, 1..n without a gap
    /// By language: SHA-256 of the texts of the exercise, its levels and its presets, lower-case hex.
    std::map<std::string, std::string> textsSha256;
};

} // namespace chiron::catalogue
