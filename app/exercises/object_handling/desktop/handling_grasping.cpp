// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/desktop/handling_grasping.h"

#include "desktop/training/grasp_texts.h"
#include "simulation/objects/grasp.h"

#include <algorithm>
#include <cstddef>

namespace chiron::desktop {

using core::LaparoscopyStep;
using simulation::HandlingTask;

namespace {

QString placeText(const session::LevelLimits& limits, const QLocale& locale) {
    const std::optional<double> placement_mm = limits.of("placement_error");
    return placement_mm
               ? GraspTexts::tr("Set it down in the middle of the ring, at most %1 mm off, and let go")
                     .arg(locale.toString(*placement_mm, 'g', 3))
               : GraspTexts::tr("Set it down inside the ring and let go");
}

QString handlingText(const core::LaparoscopyCues& cues, HandlingTask task, const session::LevelLimits& limits,
                     const QLocale& locale) {
    switch (cues.step) {
    case LaparoscopyStep::grasp:
        return task == HandlingTask::weigh
                   ? GraspTexts::tr("Lift one object after the other and find the heaviest")
                   : GraspTexts::tr("Grasp the object gently");
    case LaparoscopyStep::lift:
        return GraspTexts::tr("Lift it up");
    case LaparoscopyStep::carry:
        return task == HandlingTask::weigh
                   ? GraspTexts::tr("Is it the heaviest? Bring it over the ring; otherwise set it down")
                   : GraspTexts::tr("Bring it over the ring");
    case LaparoscopyStep::place:
        return placeText(limits, locale);
    case LaparoscopyStep::hold:
        return GraspTexts::tr("In the ring: let it lie still");
    case LaparoscopyStep::done:
        return GraspTexts::tr("Done: the next one follows");
    case LaparoscopyStep::none:
    case LaparoscopyStep::stretch:
    case LaparoscopyStep::retract:
    case LaparoscopyStep::handOver:
        break;
    }
    return GraspTexts::tr("Wait for the object");
}

QString heldObject(const core::LaparoscopyCues& cues, const QLocale& locale) {
    const int bodies = std::min(cues.bodies, static_cast<int>(core::LaparoscopyCues::kMaxBodies));
    for (int i = 0; i < bodies; ++i)
        if (cues.body[static_cast<std::size_t>(i)].heldBy != 0)
            return bodies > 1 ? GraspTexts::tr("Holding: object %1 of %2")
                                    .arg(locale.toString(i + 1), locale.toString(bodies))
                              : GraspTexts::tr("Holding: the object");
    return GraspTexts::tr("Holding: nothing");
}

} // namespace

Grasping handlingGrasping(const simulation::ObjectHandlingParameters& level,
                          const session::LevelLimits& limits) {
    Grasping grasping;
    grasping.forceLimit_N = limits.force_N;
    grasping.tools = level.tools();
    grasping.measured = Grasping::Measured::squeeze;
    grasping.measuredEnd_N = 1.5 * level.squeezeLimit_N;
    grasping.measuredLimit_N = level.squeezeLimit_N;
    const simulation::JawGeometry jaws{level.jawLength_m};
    grasping.reach_m = level.graspReach_m;
    grasping.holdsBelow_rad = jaws.angle_rad(2.0 * level.radius_m);
    grasping.opensAbove_rad = jaws.angle_rad(2.0 * level.radius_m + level.releaseClearance_m);
    grasping.step = [task = level.task, limits](const core::LaparoscopyCues& cues, const QLocale& locale) {
        return handlingText(cues, task, limits, locale);
    };
    grasping.held = heldObject;
    grasping.load = [](const haptics::DisplayState& state, const QLocale& locale) {
        // Adding 0 removes the minus sign of -0.00.
        const double pull_N = std::max(0.0, -state.tool[0].tissue[2]) + 0.0;
        return GraspPanelTexts::tr("Pull of the load, downwards: %1 N").arg(locale.toString(pull_N, 'f', 2));
    };
    return grasping;
}

} // namespace chiron::desktop
