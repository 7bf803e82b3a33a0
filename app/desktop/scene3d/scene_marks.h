// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"

#include <array>
#include <string>
#include <vector>

namespace chiron::scene3d {

/// Radii of the double ring that stands where a mark should have been, mm.
inline constexpr std::array<double, 2> kAnswerRings_mm{5.0, 2.2};

/// A level's scene as far as its marks depend on it.
struct MarkedScene {
    const SceneSetup& setup;
    bool coverage = false; ///< the level shows where was searched
    bool feedback = false; ///< what was true is drawn after a trial
};

/// The guide marks that this scene may draw beside the things themselves, in 3D and flat: names, as the content's legends use them
/// (schema/exercise.json). Who draws a new mark adds it to its exercise's (app/exercises/flat_catalogue.cpp), and its sentence to the
/// legend. Pure.
std::vector<std::string> marksOf(const MarkedScene& scene);

/// Those of the stage that most exercises share: place_marks, force_arrow, instrument. `tools`: of the level.
std::vector<std::string> stageMarks(const SceneSetup& setup, int tools);

} // namespace chiron::scene3d
