// SPDX-License-Identifier: GPL-3.0-or-later
// The exercises that are drawn in 3D, one line each. This file belongs to the library with Qt3D, which is
// loaded at run time.
#include "app/exercises/elastic_tube/scene/tube_content.h"
#include "app/exercises/object_handling/scene/handling_content.h"
#include "app/exercises/palpation/scene/palpation_scene_content.h"
#include "app/exercises/sphere_apex/scene/apex_content.h"
#include "app/exercises/urethra_insertion/scene/endoscope_stage.h"
#include "desktop/scene3d/plugin/scene_content.h"
#include "desktop/scene3d/plugin/scene_stage.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

#include <array>

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
    const char* exercise;
    MakeStage stage;
    MakeContent content; ///< content of the laparoscopic stage
    /// True if the parameters belong to this exercise.
    bool (*fits)(const SceneSetup& setup);
};

template <class Parameters> bool fits(const SceneSetup& setup) {
    return (setup.parameters.find<Parameters>() != nullptr);
}

constexpr std::array kCatalogue{
    Line{"sphere_apex", &stage<SceneStage>, &content<ApexContent>, &fits<simulation::SphereApexParameters>},
    Line{"elastic_tube", &stage<SceneStage>, &content<TubeContent>, &fits<simulation::ElasticTubeParameters>},
    Line{"object_handling", &stage<SceneStage>, &content<HandlingContent>,
         &fits<simulation::ObjectHandlingParameters>},
    Line{"palpation", &stage<SceneStage>, &content<PalpationContent>, &fits<simulation::PalpationParameters>},
    Line{"urethra_insertion", &stage<EndoscopeStage>, nullptr, &fits<simulation::UrethraInsertionParameters>},
};

const Line* find(const SceneSetup& setup) {
    for (const Line& line : kCatalogue)
        if (setup.exercise == line.exercise && line.fits(setup))
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
