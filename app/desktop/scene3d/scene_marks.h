// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"

#include <array>
#include <string>
#include <vector>

namespace chiron::scene3d {

/// Radii, in mm, of the double ring that stands where a mark should have been.
inline constexpr std::array<double, 2> kAnswerRings_mm{5.0, 2.2};

/// The properties of a level's scene that its marks depend on.
struct MarkedScene {
    const SceneSetup& setup;
    bool coverage = false; ///< the level shows which areas were searched
    bool feedback = false; ///< the true answer is drawn after a trial
};

/// Names the guide marks that this scene may draw beside the objects themselves, in 3D and flat, as the
/// content's legends use them (schema/exercise.json). To draw a new mark, add it to its exercise's list
/// (app/exercises/flat_catalogue.cpp), and add its sentence to the legend. Pure.
std::vector<std::string> marksOf(const MarkedScene& scene);

/// The marks of the stage that most exercises share: place_marks, force_arrow, instrument. `tools` is the
/// level's number of tools.
std::vector<std::string> stageMarks(const SceneSetup& setup, int tools);

} // namespace chiron::scene3d
