// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/training_plan.h"
#include "session/exercise_kind.h"

#include <QString>
#include <string>

namespace chiron::desktop {

/// Texts that set-up and training share.
QString operatorTitle(const std::string& name); ///< "an expert"; an unknown name is returned unchanged
QString deviceTitle(const TrainingPlan& plan);  ///< with whether force is felt, if a person's hand moves it
QString deviceIcon(devices::MovedBy movedBy);   ///< Breeze name
/// How to move the tool, mark, pause and stop, with what the person holds.
QString keysInWords(bool ownHand, session::PointerTool tool = session::PointerTool::point, int tools = 1,
                    devices::HandKind hand = devices::HandKind::mouseAndKeyboard);
/// Names the instrument that mouse and keyboard move: `tool` counts from 0.
QString activeToolInWords(int tool, int tools);

} // namespace chiron::desktop
