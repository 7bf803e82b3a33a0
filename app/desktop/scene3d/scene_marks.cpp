// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/scene_marks.h"

namespace chiron::scene3d {

namespace {

using Marks = std::vector<std::string>;

int toolsIn(const SceneSetup& setup) {
    if (const auto* tube = std::get_if<simulation::ElasticTubeParameters>(&setup.parameters))
        return tube->tools();
    if (const auto* palpation = std::get_if<simulation::PalpationParameters>(&setup.parameters))
        return palpation->tools();
    return 1;
}

void addEndoscope(Marks& marks, const SceneSetup& setup, const simulation::UrethraInsertionParameters& parameters) {
    if (setup.cues.object && setup.cues.guidance) {
        marks.insert(marks.end(), {"lumen_ring"});
        if (!parameters.landmarks.empty())
            marks.insert(marks.end(), {"landmark_rings"});
    }
    if (setup.cues.arrow)
        marks.push_back("force_across");
    if (setup.cues.overview)
        marks.push_back("overview");
}

void addTube(Marks& marks, const SceneSetup& setup, const simulation::ElasticTubeParameters& parameters) {
    if (!setup.cues.object)
        return;
    marks.push_back("tube_rings");
    if (parameters.task == simulation::TubeTask::transfer || parameters.task == simulation::TubeTask::stretch)
        marks.push_back("target_ring");
}

void addPalpation(Marks& marks, const MarkedScene& scene) {
    marks.insert(marks.end(), {"search_area", "finding"});
    if (scene.setup.cues.tool)
        marks.push_back("finger_ring");
    if (scene.setup.cues.object)
        marks.push_back("lump");
    if (scene.coverage)
        marks.push_back("hatching");
    if (scene.feedback)
        marks.push_back("lump_answer");
}

/// Of the stage round every content but the endoscope's: place_marks, force_arrow, instrument.
void addStage(Marks& marks, const SceneSetup& setup) {
    if (setup.cues.arrow)
        marks.insert(marks.end(), {"force_arrow", "force_limit"});
    if (setup.cues.tool)
        marks.push_back("drop_line");
    if (setup.cues.tool && toolsIn(setup) > 1)
        marks.push_back("tool_rings");
}

} // namespace

std::vector<std::string> marksOf(const MarkedScene& scene) {
    Marks marks;
    if (const auto* endoscopy = std::get_if<simulation::UrethraInsertionParameters>(&scene.setup.parameters)) {
        addEndoscope(marks, scene.setup, *endoscopy);
        return marks;
    }
    addStage(marks, scene.setup);
    if (const auto* tube = std::get_if<simulation::ElasticTubeParameters>(&scene.setup.parameters))
        addTube(marks, scene.setup, *tube);
    else if (std::holds_alternative<simulation::ObjectHandlingParameters>(scene.setup.parameters) && scene.setup.cues.object)
        marks.push_back("target_ring");
    else if (std::holds_alternative<simulation::PalpationParameters>(scene.setup.parameters))
        addPalpation(marks, scene);
    else if (std::holds_alternative<simulation::SphereApexParameters>(scene.setup.parameters) && scene.feedback)
        marks.push_back("apex_answer");
    return marks;
}

} // namespace chiron::scene3d
