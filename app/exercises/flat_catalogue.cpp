// SPDX-License-Identifier: GPL-3.0-or-later
// The exercises that are drawn flat: a line each.
#include "app/exercises/comparison/scene/flat_comparison.h"
#include "app/exercises/elastic_tube/scene/flat_tube.h"
#include "app/exercises/object_handling/scene/flat_handling.h"
#include "app/exercises/palpation/scene/flat_palpation.h"
#include "app/exercises/sphere_apex/scene/flat_apex.h"
#include "app/exercises/urethra_insertion/scene/flat_urethra.h"
#include "desktop/scene2d/flat_content.h"

#include <array>

namespace chiron::scene3d {

namespace {

/// Empty where the parameters are of another kind.
using MakeFlat = std::unique_ptr<IFlatContent> (*)(const SceneSetup&);

template <class Content, class Parameters> std::unique_ptr<IFlatContent> flat(const SceneSetup& setup) {
    const auto* parameters = std::get_if<Parameters>(&setup.parameters);
    return parameters ? std::make_unique<Content>(*parameters) : nullptr;
}

struct FlatLine {
    const char* exercise;
    MakeFlat make;
};

constexpr std::array kFlatCatalogue{
    FlatLine{"sphere_apex", &flat<FlatApex, simulation::SphereApexParameters>},
    FlatLine{"urethra_insertion", &flat<FlatUrethra, simulation::UrethraInsertionParameters>},
    FlatLine{"elastic_tube", &flat<FlatTube, simulation::ElasticTubeParameters>},
    FlatLine{"object_handling", &flat<FlatHandling, simulation::ObjectHandlingParameters>},
    FlatLine{"palpation", &flat<FlatPalpation, simulation::PalpationParameters>},
    FlatLine{"comparison", &flat<FlatComparison, simulation::ComparisonParameters>},
};

} // namespace

std::unique_ptr<IFlatContent> makeFlatContent(const SceneSetup& setup) {
    for (const FlatLine& line : kFlatCatalogue)
        if (setup.exercise == line.exercise)
            return line.make(setup);
    return nullptr;
}

} // namespace chiron::scene3d
