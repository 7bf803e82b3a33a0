// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laparoscopy_cues.h"
#include "desktop/training/grasping.h"
#include "session_report/tool_words.h"

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// Which of the steps of a grasping exercise it is, as one sentence about what to do now. Pure, as all of these.
QString stepText(const core::LaparoscopyCues& cues, const Grasping& grasping, const QLocale& locale);
using session_report::instrumentName;
/// What is held: "Holding: the end of the tube", "Holding: object 2 of 3", "Holding: nothing".
QString heldText(const core::LaparoscopyCues& cues, const Grasping& grasping, const QLocale& locale);

} // namespace chiron::desktop
