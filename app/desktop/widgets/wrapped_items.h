// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

class QListView;

namespace chiron::desktop {

/// Makes a list wrap the texts of its items as far as its width asks for, and never shorten or scroll them
/// sideways.
/// Thread: GUI.
void wrapItems(QListView& list, const Theme& theme);

} // namespace chiron::desktop
