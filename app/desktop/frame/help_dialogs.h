// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/command_list.h"
#include "desktop/theme/theme.h"

class QDialog;
class QWidget;

namespace chiron::desktop {

/// "?": every shortcut that works now, by group. Shown without blocking; deletes itself. GUI thread.
QDialog* showShortcuts(const Theme& theme, const std::vector<CommandGroup>& groups, QWidget* parent);
/// F1: what the screen is for, and its own commands. Shown without blocking; deletes itself. GUI thread.
QDialog* showHelp(const Theme& theme, Screen& screen, QWidget* parent);

/// Words that had no room where they were said. Shown without blocking; deletes itself. GUI thread.
QDialog* showWords(const Theme& theme, const QString& title, const QString& text, QWidget* parent);

} // namespace chiron::desktop
