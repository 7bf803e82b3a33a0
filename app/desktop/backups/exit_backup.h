// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::desktop {

class AppContext;

/// The day's backup while the program closes, where it is still due: a small window says so and lets it be left out. A failure is
/// noted in the site and told to administrators at the next start; it keeps nobody here. Returns when it is over. GUI thread,
/// after the application's event loop has ended.
void backUpAtExit(AppContext& context);

} // namespace chiron::desktop
