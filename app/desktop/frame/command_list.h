// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"

#include <vector>

namespace chiron::desktop {

class AppContext;

/// A group of commands as the palette and the list of shortcuts show it.
struct CommandGroup {
    QString title; ///< translated
    std::vector<ScreenCommand> commands;
};

/// What the main window itself offers, handed in by it.
struct WindowActions {
    std::function<void()> palette;
    std::function<void()> shortcuts;
    std::function<void()> help;
    std::function<void()> about;
    std::function<void()> close;
};

/// Every command that can be given now: the screen's, the places that the person's roles give, the program's. GUI thread.
std::vector<CommandGroup> commandsNow(AppContext& context, Screen* screen, const WindowActions& window);

} // namespace chiron::desktop
