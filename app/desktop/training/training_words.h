// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/training_plan.h"
#include "session/exercise_kind.h"

#include <QString>
#include <string>

namespace chiron::desktop {

/// Words that set-up and training share.
QString operatorTitle(const std::string& name); ///< "an expert"; a name that is not known as it is
QString deviceTitle(const TrainingPlan& plan);  ///< with what is felt of it
QString deviceIcon(devices::MovedBy movedBy);   ///< Breeze name
/// How the tool is moved, marked, paused, stopped.
QString keysInWords(bool ownHand, session::PointerTool tool = session::PointerTool::point, int tools = 1);
/// Which of several instruments the mouse and the keyboard move: `tool` from 0.
QString activeToolInWords(int tool, int tools);

} // namespace chiron::desktop
