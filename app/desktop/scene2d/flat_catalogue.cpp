// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene2d/flat_content.h"
#include "desktop/scene2d/sphere_apex/flat_apex.h"

namespace chiron::scene3d {

std::unique_ptr<IFlatContent> makeFlatContent(const SceneSetup& setup) {
    if (setup.exercise == "sphere_apex")
        return std::make_unique<FlatApex>(std::get<simulation::SphereApexParameters>(setup.parameters));
    return nullptr;
}

} // namespace chiron::scene3d
