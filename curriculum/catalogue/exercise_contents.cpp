// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/exercise_contents.h"

#include "catalogue/comparison_content.h"
#include "curriculum/exercises/elastic_tube/catalogue/elastic_tube_content.h"
#include "curriculum/exercises/object_handling/catalogue/object_handling_content.h"
#include "curriculum/exercises/palpation/catalogue/palpation_content.h"
#include "curriculum/exercises/sphere_apex/catalogue/sphere_apex_content.h"
#include "curriculum/exercises/urethra_insertion/catalogue/urethra_insertion_content.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <array>

namespace chiron::catalogue {

namespace {
template <class Parameters> int toolsOf(const ExerciseParameters& parameters) {
    return parameters.as<Parameters>().tools();
}
} // namespace

std::span<const ExerciseContent> exerciseContents() {
    // One line per exercise, in the order in which people see them.
    static constexpr auto kContents = std::to_array<ExerciseContent>({
        {"sphere_apex", "sphere_apex_parameters", sphereApexSchema, readSphereApex, checkSphereApex},
        {"urethra_insertion", "urethra_insertion_parameters", urethraInsertionSchema, readUrethraInsertion,
         checkUrethraInsertion, "tissue"},
        {"elastic_tube", "elastic_tube_parameters", elasticTubeSchema, readElasticTube, checkElasticTube, "",
         toolsOf<simulation::ElasticTubeParameters>},
        {"object_handling", "object_handling_parameters", objectHandlingSchema, readObjectHandling,
         checkObjectHandling, "", toolsOf<simulation::ObjectHandlingParameters>},
        {"palpation", "palpation_parameters", palpationSchema, readPalpation, checkPalpation, "",
         toolsOf<simulation::PalpationParameters>},
        // Used by studies: no content file has such an exercise.
        {"comparison", "comparison_parameters", nullptr, readComparison, checkComparison},
    });
    return kContents;
}

const ExerciseContent* findExerciseContent(std::string_view id) {
    for (const ExerciseContent& content : exerciseContents())
        if (content.id == id)
            return &content;
    return nullptr;
}

} // namespace chiron::catalogue
