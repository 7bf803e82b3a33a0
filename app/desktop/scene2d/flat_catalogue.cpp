// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/comparison/scene/flat_comparison.h"
#include "desktop/scene2d/flat_content.h"
#include "app/exercises/object_handling/scene/flat_handling.h"
#include "app/exercises/elastic_tube/scene/flat_tube.h"
#include "app/exercises/palpation/scene/flat_palpation.h"
#include "app/exercises/sphere_apex/scene/flat_apex.h"
#include "app/exercises/urethra_insertion/scene/flat_urethra.h"

namespace chiron::scene3d {

std::unique_ptr<IFlatContent> makeFlatContent(const SceneSetup& setup) {
    const auto* ball = std::get_if<simulation::SphereApexParameters>(&setup.parameters);
    const auto* urethra = std::get_if<simulation::UrethraInsertionParameters>(&setup.parameters);
    if (setup.exercise == "sphere_apex" && ball)
        return std::make_unique<FlatApex>(*ball);
    if (setup.exercise == "urethra_insertion" && urethra)
        return std::make_unique<FlatUrethra>(*urethra);
    const auto* tube = std::get_if<simulation::ElasticTubeParameters>(&setup.parameters);
    const auto* handling = std::get_if<simulation::ObjectHandlingParameters>(&setup.parameters);
    if (setup.exercise == "elastic_tube" && tube)
        return std::make_unique<FlatTube>(*tube);
    if (setup.exercise == "object_handling" && handling)
        return std::make_unique<FlatHandling>(*handling);
    const auto* palpation = std::get_if<simulation::PalpationParameters>(&setup.parameters);
    if (setup.exercise == "palpation" && palpation)
        return std::make_unique<FlatPalpation>(*palpation);
    const auto* comparison = std::get_if<simulation::ComparisonParameters>(&setup.parameters);
    if (setup.exercise == "comparison" && comparison)
        return std::make_unique<FlatComparison>(*comparison);
    return nullptr;
}

} // namespace chiron::scene3d
