// SPDX-License-Identifier: GPL-3.0-or-later
// The exercises that can be run: a line each.
#include "app/exercises/comparison/session/comparison_kind.h"
#include "app/exercises/elastic_tube/session/elastic_tube_kind.h"
#include "app/exercises/object_handling/session/object_handling_kind.h"
#include "app/exercises/palpation/session/palpation_kind.h"
#include "app/exercises/sphere_apex/session/sphere_apex_kind.h"
#include "app/exercises/urethra_insertion/session/urethra_insertion_kind.h"
#include "session/exercise_kind.h"

#include <array>

namespace chiron::session {

core::Result<const ExerciseKind*> exerciseKind(std::string_view id) {
    static const SphereApexKind sphereApex;
    static const UrethraInsertionKind urethraInsertion;
    static const ElasticTubeKind elasticTube;
    static const ObjectHandlingKind objectHandling;
    static const PalpationKind palpation;
    static const ComparisonKind comparison; // of studies
    static const auto kinds =
        std::to_array<const ExerciseKind*>({&sphereApex, &urethraInsertion, &elasticTube, &objectHandling, &palpation, &comparison});
    std::string known;
    for (const ExerciseKind* kind : kinds) {
        if (kind->id() == id)
            return kind;
        known += (known.empty() ? "" : ", ") + std::string(kind->id());
    }
    return core::fail(core::ErrorCode::notFound, "exercise \"" + std::string(id) + "\": expected one of " + known);
}

} // namespace chiron::session
