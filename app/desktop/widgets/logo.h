// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

class QLabel;

namespace chiron::desktop {

class Theme;

/// The program's own sign, the same in every theme: of windows, and wherever the program says its name. GUI thread.
QIcon logoIcon();

/// The sign alone, in the middle of its room; `size_px` at 100 %. For the eye only: its neighbour says the name.
QLabel* logo(const Theme& theme, int size_px);

} // namespace chiron::desktop
