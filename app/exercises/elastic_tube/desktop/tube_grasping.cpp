// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/desktop/tube_grasping.h"

#include "app/exercises/elastic_tube/scene/tension_bar.h"
#include "desktop/training/grasp_texts.h"

#include <cmath>

namespace chiron::desktop {

using core::LaparoscopyStep;
using simulation::TubeTask;

namespace {

QString graspTube(TubeTask task) {
    switch (task) {
    case TubeTask::twoHanded:
        return GraspTexts::tr("Take hold of both ends of the tube, one with each instrument");
    case TubeTask::transfer:
        return GraspTexts::tr("Take hold of the end of the tube with the right instrument");
    case TubeTask::hold:
    case TubeTask::stretch:
        break;
    }
    return GraspTexts::tr("Take hold of the end of the tube");
}

QString holdTube(TubeTask task) {
    switch (task) {
    case TubeTask::stretch:
        return GraspTexts::tr("At the mark: hold it there");
    case TubeTask::transfer:
        return GraspTexts::tr("At the target: hold it there");
    case TubeTask::hold:
    case TubeTask::twoHanded:
        break;
    }
    return GraspTexts::tr("In the band: keep the tension there");
}

QString tubeText(const core::LaparoscopyCues& cues, TubeTask task) {
    if (cues.torn)
        return GraspTexts::tr("The tube is torn: this trial is over");
    switch (cues.step) {
    case LaparoscopyStep::grasp:
        return graspTube(task);
    case LaparoscopyStep::stretch:
        return task == TubeTask::stretch ? GraspTexts::tr("Stretch the tube to the mark, and no farther")
                                         : GraspTexts::tr("Pull until the tension is in its band");
    case LaparoscopyStep::hold:
        return holdTube(task);
    case LaparoscopyStep::handOver:
        return GraspTexts::tr("Take the tube over with the left instrument, then let go with the right one");
    case LaparoscopyStep::lift:
        return GraspTexts::tr("Lift the end of the tube");
    case LaparoscopyStep::carry:
        return GraspTexts::tr("Bring the end of the tube to the target");
    case LaparoscopyStep::place:
        return GraspTexts::tr("Let go of the end of the tube");
    case LaparoscopyStep::retract:
        return GraspTexts::tr(
            "Retract the fold of tissue with the third instrument until the pull is in the band");
    case LaparoscopyStep::done:
        return GraspTexts::tr("Done: the next tube follows");
    case LaparoscopyStep::none:
        break;
    }
    return GraspTexts::tr("Wait for the tube");
}

QString heldTube(const core::LaparoscopyCues& cues) {
    int held = 0;
    for (int i = 0; i < cues.grips; ++i)
        held += cues.gripHeldBy[static_cast<std::size_t>(i)] != 0 ? 1 : 0;
    if (cues.foldHeldBy != 0)
        return held > 1   ? GraspTexts::tr("Holding: the fold, and the tube at two points")
               : held > 0 ? GraspTexts::tr("Holding: the fold, and the tube at one point")
                          : GraspTexts::tr("Holding: the fold");
    if (held > 0)
        return held > 1 ? GraspTexts::tr("Holding: the tube at two points")
                        : GraspTexts::tr("Holding: the tube");
    return GraspTexts::tr("Holding: nothing");
}

} // namespace

Grasping tubeGrasping(const simulation::ElasticTubeParameters& level, const session::LevelLimits& limits) {
    Grasping grasping;
    grasping.forceLimit_N = limits.force_N;
    grasping.tools = level.tools();
    grasping.measured = Grasping::Measured::tension;
    grasping.measuredEnd_N = scene3d::tensionEnd_N(level);
    if (level.hasFold()) {
        grasping.retractionEnd_N = 1.8 * level.retractionHigh_N;
        grasping.retractionLimit_N = limits.of("retraction_max").value_or(0.0);
        grasping.retractor = level.retractor();
    }
    grasping.reach_m = level.graspReach_m;
    grasping.holdsBelow_rad = level.graspAngle_rad;
    grasping.opensAbove_rad = level.releaseAngle_rad;
    grasping.step = [task = level.task](const core::LaparoscopyCues& cues, const QLocale&) {
        return tubeText(cues, task);
    };
    grasping.held = [](const core::LaparoscopyCues& cues, const QLocale&) { return heldTube(cues); };
    grasping.load = [](const haptics::DisplayState& state, const QLocale& locale) {
        const double stretch_mm = 1e3 * state.exercise.of<core::LaparoscopyCues>().stretch_m;
        // Adding 0 removes the minus sign of -0.0.
        return GraspPanelTexts::tr("Stretched by %1 mm")
            .arg(locale.toString(std::round(stretch_mm * 10.0) / 10.0 + 0.0, 'f', 1));
    };
    return grasping;
}

} // namespace chiron::desktop
