// SPDX-License-Identifier: GPL-3.0-or-later
// The exercises that are drawn in 3D: one for each line of exercise_catalogue.h that has a stage. This file
// belongs to the library with Qt3D, which is loaded at run time.
#include "app/exercises/elastic_tube/scene/tube_content.h"
#include "app/exercises/exercise_catalogue.h"
#include "app/exercises/object_handling/scene/handling_content.h"
#include "app/exercises/palpation/scene/palpation_scene_content.h"
#include "app/exercises/sphere_apex/scene/apex_content.h"
#include "app/exercises/urethra_insertion/scene/endoscope_stage.h"
#include "desktop/scene3d/plugin/scene_content.h"
#include "desktop/scene3d/plugin/scene_stage.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "simulation/comparison/comparison_parameters.h"

#include <array>
#include <type_traits>

namespace chiron::scene3d {

namespace {

using MakeStage = std::unique_ptr<IStage> (*)(const SceneSetup&, QObject*);
using MakeContent = std::unique_ptr<ISceneContent> (*)(const SceneSetup&, SharedLight&, Qt3DCore::QEntity*);

template <class Stage> std::unique_ptr<IStage> stage(const SceneSetup& setup, QObject* surface) {
    return std::make_unique<Stage>(setup, surface);
}

template <class Content>
std::unique_ptr<ISceneContent> content(const SceneSetup& setup, SharedLight& light,
                                       Qt3DCore::QEntity* parent) {
    return std::make_unique<Content>(setup, light, parent);
}

struct Line {
    const char* exercise = "";
    MakeStage stage = nullptr;     ///< null: it is drawn flat only
    MakeContent content = nullptr; ///< content of the laparoscopic stage
    /// True if the parameters belong to this exercise.
    bool (*fits)(const SceneSetup& setup) = nullptr;
};

template <class Parameters> bool fits(const SceneSetup& setup) {
    return (setup.parameters.find<Parameters>() != nullptr);
}

template <class Exercise> constexpr Line lineOf() {
    Line line{Exercise::kId, nullptr, nullptr, &fits<typename Exercise::Parameters>};
    if constexpr (!std::is_void_v<typename Exercise::Stage>)
        line.stage = &stage<typename Exercise::Stage>;
    if constexpr (!std::is_void_v<typename Exercise::Content>)
        line.content = &content<typename Exercise::Content>;
    return line;
}

template <class... Exercises> constexpr auto linesOf(exercises::List<Exercises...>) {
    return std::array{lineOf<Exercises>()...};
}

constexpr auto kCatalogue = linesOf(exercises::All{});

const Line* find(const SceneSetup& setup) {
    for (const Line& line : kCatalogue)
        if (line.stage != nullptr && setup.exercise == line.exercise && line.fits(setup))
            return &line;
    return nullptr;
}

} // namespace

bool hasStage(const SceneSetup& setup) {
    return find(setup) != nullptr;
}

std::unique_ptr<IStage> makeStage(const SceneSetup& setup, QObject* surface) {
    const Line* line = find(setup);
    return line ? line->stage(setup, surface) : nullptr;
}

std::unique_ptr<ISceneContent> makeSceneContent(const SceneSetup& setup, SharedLight& light,
                                                Qt3DCore::QEntity* parent) {
    const Line* line = find(setup);
    return line && line->content ? line->content(setup, light, parent) : nullptr;
}

} // namespace chiron::scene3d
