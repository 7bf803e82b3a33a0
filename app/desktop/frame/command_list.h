// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"

#include <vector>

namespace chiron::desktop {

class AppContext;

/// A group of commands, as shown in the palette and in the list of shortcuts.
struct CommandGroup {
    QString title; ///< translated
    std::vector<ScreenCommand> commands;
};

/// The actions that the main window itself offers.
struct WindowActions {
    std::function<void()> palette;
    std::function<void()> shortcuts;
    std::function<void()> help;
    std::function<void()> about;
    std::function<void()> close;
};

/// All commands that are available now: those of the screen, the screens that the person's roles may open,
/// and those of the program.
/// Thread: GUI.
std::vector<CommandGroup> commandsNow(AppContext& context, Screen* screen, const WindowActions& window);

} // namespace chiron::desktop
