// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/demo_study.h"

#include <QJsonObject>
#include <QString>

namespace chiron::cli {

/// The demonstration's study as `demo` prints it: each participant and the group, marked as rendered or not
/// rendered.
QString demoStudyTable(const session::DemoStudy& study);
/// study, condition, draft, simulated, runs[]{participant, observer, rendered, session_id, estimate,
/// choices_same}, group, replay_identical.
QJsonObject demoStudyJson(const session::DemoStudy& study);

} // namespace chiron::cli
