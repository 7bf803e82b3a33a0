// SPDX-License-Identifier: GPL-3.0-or-later
// The exercises that can be run, one line each.
#include "app/exercises/elastic_tube/session/elastic_tube_kind.h"
#include "app/exercises/object_handling/session/object_handling_kind.h"
#include "app/exercises/palpation/session/palpation_kind.h"
#include "app/exercises/sphere_apex/session/sphere_apex_kind.h"
#include "app/exercises/urethra_insertion/session/urethra_insertion_kind.h"
#include "session/exercise_kind.h"
#include "session/study/comparison_kind.h"

#include <array>

namespace chiron::session {

std::span<const ExerciseKind* const> exerciseKinds() {
    static const SphereApexKind sphereApex;
    static const UrethraInsertionKind urethraInsertion;
    static const ElasticTubeKind elasticTube;
    static const ObjectHandlingKind objectHandling;
    static const PalpationKind palpation;
    static const ComparisonKind comparison; // used by studies only
    static const auto kinds = std::to_array<const ExerciseKind*>(
        {&sphereApex, &urethraInsertion, &elasticTube, &objectHandling, &palpation, &comparison});
    return kinds;
}

} // namespace chiron::session
