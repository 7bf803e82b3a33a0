// SPDX-License-Identifier: GPL-3.0-or-later
// The exercises that the screens show, one line each.
#include "app/exercises/elastic_tube/desktop/elastic_tube_face.h"
#include "app/exercises/object_handling/desktop/object_handling_face.h"
#include "app/exercises/palpation/desktop/palpation_face.h"
#include "app/exercises/sphere_apex/desktop/sphere_apex_face.h"
#include "app/exercises/urethra_insertion/desktop/urethra_insertion_face.h"
#include "desktop/exercise_face.h"
#include "desktop/study_run/comparison_face.h"

#include <array>
#include <string>

namespace chiron::desktop {

core::Result<const ExerciseFace*> exerciseFace(std::string_view id) {
    static const SphereApexFace sphereApex;
    static const UrethraInsertionFace urethraInsertion;
    static const ElasticTubeFace elasticTube;
    static const ObjectHandlingFace objectHandling;
    static const PalpationFace palpation;
    static const ComparisonFace comparison; // used by studies only
    static const auto faces = std::to_array<const ExerciseFace*>(
        {&sphereApex, &urethraInsertion, &elasticTube, &objectHandling, &palpation, &comparison});
    std::string known;
    for (const ExerciseFace* face : faces) {
        if (face->id() == id)
            return face;
        known += (known.empty() ? "" : ", ") + std::string(face->id());
    }
    return core::fail(core::ErrorCode::notFound,
                      "exercise \"" + std::string(id) + "\": expected one of " + known);
}

} // namespace chiron::desktop
