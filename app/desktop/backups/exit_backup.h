// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::desktop {

class AppContext;

/// Makes the daily backup while the program closes, if it is still due. A small window says so and lets the
/// person skip it. A failure does not keep the program open: it is stored in the site and reported to
/// administrators at the next start. The call returns when the backup has ended.
/// Thread: GUI, after the application's event loop has ended.
void backUpAtExit(AppContext& context);

} // namespace chiron::desktop
