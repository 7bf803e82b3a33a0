// SPDX-License-Identifier: GPL-3.0-or-later
// The exercises that are drawn flat: one for each line of exercise_catalogue.h.
#include "app/exercises/elastic_tube/scene/flat_tube.h"
#include "app/exercises/exercise_catalogue.h"
#include "app/exercises/object_handling/scene/flat_handling.h"
#include "app/exercises/palpation/scene/flat_palpation.h"
#include "app/exercises/sphere_apex/scene/flat_apex.h"
#include "app/exercises/urethra_insertion/scene/flat_urethra.h"
#include "desktop/scene2d/flat_comparison.h"
#include "desktop/scene2d/flat_content.h"
#include "desktop/scene3d/scene_marks.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "simulation/comparison/comparison_parameters.h"

#include <array>

namespace chiron::scene3d {

namespace {

/// Returns null if the parameters belong to another exercise.
using MakeFlat = std::unique_ptr<IFlatContent> (*)(const SceneSetup&);

template <class Content, class Parameters> std::unique_ptr<IFlatContent> flat(const SceneSetup& setup) {
    const auto* parameters = setup.parameters.find<Parameters>();
    return parameters ? std::make_unique<Content>(*parameters) : nullptr;
}

using NameMarks = std::vector<std::string> (*)(const MarkedScene&);

template <class Content, class Parameters> std::vector<std::string> marks(const MarkedScene& scene) {
    const auto* parameters = scene.setup.parameters.find<Parameters>();
    return parameters ? Content::marks(*parameters, scene) : std::vector<std::string>();
}

struct FlatLine {
    const char* exercise;
    MakeFlat make;
    NameMarks marks;
};

template <class Exercise> constexpr FlatLine lineOf() {
    using Content = typename Exercise::Flat;
    using Parameters = typename Exercise::Parameters;
    return {Exercise::kId, &flat<Content, Parameters>, &marks<Content, Parameters>};
}

template <class... Exercises> constexpr auto linesOf(exercises::List<Exercises...>) {
    return std::array{lineOf<Exercises>()...};
}

constexpr auto kFlatCatalogue = linesOf(exercises::All{});

} // namespace

std::unique_ptr<IFlatContent> makeFlatContent(const SceneSetup& setup) {
    for (const FlatLine& line : kFlatCatalogue)
        if (setup.exercise == line.exercise)
            return line.make(setup);
    return nullptr;
}

std::vector<std::string> marksOf(const MarkedScene& scene) {
    for (const FlatLine& line : kFlatCatalogue)
        if (scene.setup.exercise == line.exercise)
            return line.marks(scene);
    return {};
}

} // namespace chiron::scene3d
