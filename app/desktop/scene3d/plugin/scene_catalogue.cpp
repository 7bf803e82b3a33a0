// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/scene_content.h"
#include "desktop/scene3d/sphere_apex/apex_content.h"

#include <array>

namespace chiron::scene3d {

namespace {

using Make = std::unique_ptr<ISceneContent> (*)(const SceneSetup&, SharedLight&, Qt3DCore::QEntity*);

template <class Content>
std::unique_ptr<ISceneContent> make(const SceneSetup& setup, SharedLight& light, Qt3DCore::QEntity* parent) {
    return std::make_unique<Content>(setup, light, parent);
}

struct Line {
    const char* exercise;
    Make make;
};

constexpr std::array kCatalogue{
    Line{"sphere_apex", &make<ApexContent>},
};

Make find(const std::string& exercise) {
    for (const Line& line : kCatalogue)
        if (exercise == line.exercise)
            return line.make;
    return nullptr;
}

} // namespace

bool hasSceneContent(const SceneSetup& setup) {
    return find(setup.exercise) != nullptr;
}

std::unique_ptr<ISceneContent> makeSceneContent(const SceneSetup& setup, SharedLight& light,
                                                Qt3DCore::QEntity* parent) {
    const Make maker = find(setup.exercise);
    return maker ? maker(setup, light, parent) : nullptr;
}

} // namespace chiron::scene3d
