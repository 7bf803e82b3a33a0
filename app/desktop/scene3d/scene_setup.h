// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exercise_parameters.h"

#include <QColor>
#include <QString>
#include <string>

namespace chiron::scene3d {

/// What a level shows in the scene: the cues of its content (the `shown` ones if no force is felt).
struct SceneCues {
    bool tool = true;
    bool arrow = false;    ///< force arrow with the limit line
    bool object = true;    ///< endoscopy: the camera's picture
    bool overview = false; ///< endoscopy: the second picture, from outside
    bool guidance = false; ///< endoscopy: the path is marked in the picture
};

/// The theme's colours that the scene uses. Tissue and instruments keep their own realistic colours.
struct SceneColours {
    QColor background{232, 237, 242};
    QColor field{205, 214, 222}; ///< operating field (drape)
    QColor ink{27, 38, 49};      ///< lines and text
    QColor arrow{0, 95, 135};    ///< force under the limit
    QColor over{176, 32, 36};    ///< force over the limit
    QColor stop{168, 30, 34};    ///< the sign over a scene whose force is stopped
    QColor ghost{120, 90, 160};
    bool highContrast = false;
};

/// The part of a scene that stays constant while it is on the screen. The parameters are the level's own, so
/// the drawn surface is computed from the same geometry as the force.
struct SceneSetup {
    std::string exercise; ///< id of the exercise: which geometry is drawn
    core::ExerciseParameters parameters;
    double forceLimit_N = 4.0; ///< limit that the arrow's line shows
    SceneCues cues;
    SceneColours colours;
    bool depthOfField = false; ///< endoscopy: the camera's picture is sharp at one distance only (P1)
    bool leftHanded = false;   ///< the entry point of a tool without orientation lies on the left
    double scale = 1.0;        ///< of lines and text: 1..2
    QString family;            ///< font
};

} // namespace chiron::scene3d
