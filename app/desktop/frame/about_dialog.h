// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QDialog;
class QWidget;

namespace chiron::desktop {

class Theme;

/// Shows the program's purpose, version, build and licence. The dialog does not block and deletes itself.
/// Thread: GUI.
QDialog* showAbout(const Theme& theme, QWidget* parent);

} // namespace chiron::desktop
