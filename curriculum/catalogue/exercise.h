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

/// A text in the languages the content has ("en" always), UTF-8.
using Translated = std::map<std::string, std::string>;

/// The text in `language` ("de", "el", ...), else in English.
const std::string& textIn(const Translated& text, const std::string& language);

using core::ExerciseParameters;

struct MetricChoice {
    std::string id;
    int version = 1;
};

/// How a level that needs a device with force is offered on one without: the force is shown, not felt, by
/// these cues, and its scores are a series of their own.
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
    std::vector<std::string>
        cues;                ///< object, tool, arrow, bars, numbers, plots, sound, coverage: all else is off
    bool feedback = false;   ///< after an answer the scene tells how good it was: for training, not for assessment
    bool needsForce = false; ///< no visible object: needs a device that renders force
    std::optional<ShownForceVariant> shownForce;
    ExerciseParameters parameters;
    /// How the base of each instrument's device stands, in the order of the instruments, beside where the exercise puts it; those left out
    /// stand there. A person or a command line may mount them otherwise.
    std::vector<core::BaseMounting> mounting;
    std::vector<MetricChoice> metrics; ///< in the order shown
    std::vector<scoring::Gate> gates;
    std::string exercise; ///< id of the exercise
    int exerciseVersion = 1;
    std::string
        resolvedJson; ///< canonical JSON of the level with every default filled in: what a session stores
    std::string resolvedSha256; ///< of those bytes, lower-case hex
};

/// What something drawn in the scene means.
struct LegendLine {
    std::string mark; ///< which one; told on levels whose scene may draw it
    Translated text;
};

/// What to do otherwise when a metric's gate did not hold.
struct Advice {
    std::string metric;
    Translated text;

    bool operator==(const Advice&) const = default;
};

struct Exercise {
    std::string id;
    int version = 1;
    Translated title;
    Translated objective;
    std::vector<Advice> advice; ///< as written: what causes other misses comes before them; each metric once, may lack some
    std::vector<LegendLine> legend; ///< in the order told
    std::vector<ExerciseLevel> levels; ///< by number, 1..n without a gap
    std::map<std::string, std::string> textsSha256; ///< by language: SHA-256 of its texts and those of its levels and presets, lower-case hex
};

} // namespace chiron::catalogue
