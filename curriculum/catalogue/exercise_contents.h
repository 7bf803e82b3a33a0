// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "catalogue/object_reader.h"

#include <QByteArray>
#include <span>
#include <string_view>

namespace chiron::catalogue {

/// Describes how the content of an exercise is read: which schema its levels' parameters follow and how they
/// become a struct.
struct ExerciseContent {
    std::string_view id;
    std::string_view parametersSchema; ///< file in content/schema, without .json
    /// Returns that file, made of the rows of the parameters; null where no content has such parameters.
    QByteArray (*schema)();
    /// Reads the level's `parameters`, with every default filled in. A key that is absent (the content was
    /// stored before the key existed) keeps the struct's own default, which must mean what the code did
    /// before.
    ExerciseParameters (*read)(const ObjectReader& parameters, const std::vector<std::string>& cues);
    /// Checks what the range of a single key cannot express.
    void (*check)(const ExerciseParameters& parameters, const QString& path, Problems& problems);
    /// The parameter that names a preset of the exercise (exercises/<id>/presets/<name>.json). The preset's
    /// parameters apply where the level gives none of its own. "" if the exercise has no presets.
    std::string_view presetKey = "";
    /// Returns for how many instruments a level may state the mounting. It is set for exercises whose
    /// scripted operators distinguish the device's frame D from W; null means none.
    int (*mountable)(const ExerciseParameters& parameters) = nullptr;
};

std::span<const ExerciseContent> exerciseContents();
const ExerciseContent* findExerciseContent(std::string_view id);

} // namespace chiron::catalogue
