// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "catalogue/object_reader.h"

#include <span>
#include <string_view>

namespace chiron::catalogue {

/// How the content of an exercise is read: which schema its levels' parameters follow and how they become a struct.
struct ExerciseContent {
    std::string_view id;
    std::string_view parametersSchema; ///< file in content/schema, without .json
    /// From the level's `parameters` with every default filled in. A key that is not there (content stored
    /// before the key was made) leaves the struct's own default, which must mean what the code did before.
    ExerciseParameters (*read)(const ObjectReader& parameters, const std::vector<std::string>& cues);
    /// What no single key's range can say.
    void (*check)(const ExerciseParameters& parameters, const QString& path, Problems& problems);
    /// The parameter that names a preset of the exercise (exercises/<id>/presets/<name>.json), whose parameters hold where the
    /// level gives none of its own; "" where it has none.
    std::string_view presetKey = "";
    /// How many instruments a level may say the mounting of: those of an exercise whose hands know where their device stands; null: none.
    int (*mountable)(const ExerciseParameters& parameters) = nullptr;
};

std::span<const ExerciseContent> exerciseContents();
const ExerciseContent* findExerciseContent(std::string_view id);

} // namespace chiron::catalogue
