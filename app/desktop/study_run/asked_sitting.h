// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/app_context.h"

#include <QString>

namespace chiron::desktop {

/// Who is to sit down now, as the command line says it: `chiron --study KEY --person CODE`.
struct AskedSitting {
    QString study;  ///< key or number
    QString person; ///< code
};

/// Once somebody is logged in, goes to that participant's next trial; a study that is not there is said in a message. GUI thread.
void followAskedSitting(AppContext& context, const AskedSitting& asked);

} // namespace chiron::desktop
