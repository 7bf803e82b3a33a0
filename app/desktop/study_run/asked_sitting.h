// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/app_context.h"

#include <QString>

namespace chiron::desktop {

/// The study and participant named on the command line: `chiron --study KEY --person CODE`.
struct AskedSitting {
    QString study;  ///< key or number
    QString person; ///< the participant's code
};

/// Opens that participant's next condition once somebody is logged in. If the study does not exist, a message
/// says so.
/// Thread: GUI.
void followAskedSitting(AppContext& context, const AskedSitting& asked);

} // namespace chiron::desktop
