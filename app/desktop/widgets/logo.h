// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

class QLabel;

namespace chiron::desktop {

class Theme;

/// The program's own icon, the same in every theme, for windows and wherever the program's name appears.
/// Thread: GUI.
QIcon logoIcon();

/// The logo alone, centred in its space; `size_px` at 100 %. It is decorative: the text beside it names the
/// program.
QLabel* logo(const Theme& theme, int size_px);

} // namespace chiron::desktop
