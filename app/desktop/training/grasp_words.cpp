// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/grasp_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <cstddef>

namespace chiron::desktop {

using core::LaparoscopyStep;
using simulation::HandlingTask;
using simulation::TubeTask;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(GraspWords)
};

QString graspTube(TubeTask task) {
    switch (task) {
    case TubeTask::twoHanded: return Words::tr("Take hold of both ends of the tube, one with each instrument");
    case TubeTask::transfer: return Words::tr("Take hold of the end of the tube with the right instrument");
    case TubeTask::hold:
    case TubeTask::stretch: break;
    }
    return Words::tr("Take hold of the end of the tube");
}

QString holdTube(TubeTask task) {
    switch (task) {
    case TubeTask::stretch: return Words::tr("At the mark: hold it there");
    case TubeTask::transfer: return Words::tr("At the target: hold it there");
    case TubeTask::hold:
    case TubeTask::twoHanded: break;
    }
    return Words::tr("In the band: keep the tension there");
}

QString tubeText(const core::LaparoscopyCues& cues, TubeTask task) {
    if (cues.torn)
        return Words::tr("The tube is torn: this trial is over");
    switch (cues.step) {
    case LaparoscopyStep::grasp: return graspTube(task);
    case LaparoscopyStep::stretch:
        return task == TubeTask::stretch ? Words::tr("Stretch the tube to the mark, and no farther")
                                         : Words::tr("Pull until the tension is in its band");
    case LaparoscopyStep::hold: return holdTube(task);
    case LaparoscopyStep::handOver: return Words::tr("Take the tube over with the left instrument, then let go with the right one");
    case LaparoscopyStep::lift: return Words::tr("Lift the end of the tube");
    case LaparoscopyStep::carry: return Words::tr("Bring the end of the tube to the target");
    case LaparoscopyStep::place: return Words::tr("Let go of the end of the tube");
    case LaparoscopyStep::retract: return Words::tr("Retract the fold of tissue with the third instrument until the pull is in the band");
    case LaparoscopyStep::done: return Words::tr("Done: the next tube follows");
    case LaparoscopyStep::none: break;
    }
    return Words::tr("Wait for the tube");
}

QString placeText(const session::LevelLimits& limits, const QLocale& locale) {
    return limits.placement_mm ? Words::tr("Set it down in the middle of the ring, at most %1 mm off, and let go").arg(locale.toString(*limits.placement_mm, 'g', 3))
                               : Words::tr("Set it down inside the ring and let go");
}

QString handlingText(const core::LaparoscopyCues& cues, const Grasping& grasping, const QLocale& locale) {
    const HandlingTask task = grasping.handling->task;
    switch (cues.step) {
    case LaparoscopyStep::grasp:
        return task == HandlingTask::weigh ? Words::tr("Lift one object after the other and find the heaviest")
                                           : Words::tr("Grasp the object gently");
    case LaparoscopyStep::lift: return Words::tr("Lift it up");
    case LaparoscopyStep::carry:
        return task == HandlingTask::weigh ? Words::tr("Is it the heaviest? Bring it over the ring; otherwise set it down")
                                           : Words::tr("Bring it over the ring");
    case LaparoscopyStep::place: return placeText(grasping.limits, locale);
    case LaparoscopyStep::hold: return Words::tr("In the ring: let it lie still");
    case LaparoscopyStep::done: return Words::tr("Done: the next one follows");
    case LaparoscopyStep::none:
    case LaparoscopyStep::stretch:
    case LaparoscopyStep::retract:
    case LaparoscopyStep::handOver: break;
    }
    return Words::tr("Wait for the object");
}

} // namespace

QString stepText(const core::LaparoscopyCues& cues, const Grasping& grasping, const QLocale& locale) {
    if (grasping.tube)
        return tubeText(cues, grasping.tube->task);
    return grasping.handling ? handlingText(cues, grasping, locale) : QString();
}

QString heldText(const core::LaparoscopyCues& cues, const Grasping& grasping, const QLocale& locale) {
    const int bodies = std::min(cues.bodies, static_cast<int>(core::LaparoscopyCues::kMaxBodies));
    for (int i = 0; i < bodies; ++i)
        if (cues.body[static_cast<std::size_t>(i)].heldBy != 0)
            return bodies > 1 ? Words::tr("Holding: object %1 of %2").arg(locale.toString(i + 1), locale.toString(bodies))
                              : Words::tr("Holding: the object");
    int held = 0;
    for (int i = 0; i < cues.grips; ++i)
        held += cues.gripHeldBy[static_cast<std::size_t>(i)] != 0 ? 1 : 0;
    if (grasping.tube && cues.foldHeldBy != 0)
        return held > 1   ? Words::tr("Holding: the fold and two places of the tube")
               : held > 0 ? Words::tr("Holding: the fold and one place of the tube")
                          : Words::tr("Holding: the fold");
    if (grasping.tube && held > 0)
        return held > 1 ? Words::tr("Holding: the tube at two points") : Words::tr("Holding: the tube");
    return Words::tr("Holding: nothing");
}

} // namespace chiron::desktop
