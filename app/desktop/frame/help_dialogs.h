// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/command_list.h"
#include "desktop/theme/theme.h"

class QDialog;
class QWidget;

namespace chiron::desktop {

/// "?": lists every shortcut that works now, by group. The dialog does not block and deletes itself.
/// Thread: GUI.
QDialog* showShortcuts(const Theme& theme, const std::vector<CommandGroup>& groups, QWidget* parent);
/// F1: shows the purpose of the screen and its own commands. The dialog does not block and deletes itself.
/// Thread: GUI.
QDialog* showHelp(const Theme& theme, Screen& screen, QWidget* parent);

/// Shows a text in full that had to be shortened elsewhere. The dialog does not block and deletes itself.
/// Thread: GUI.
QDialog* showWords(const Theme& theme, const QString& title, const QString& text, QWidget* parent);

} // namespace chiron::desktop
