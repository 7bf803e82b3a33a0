// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QDialog;
class QWidget;

namespace chiron::desktop {

class Theme;

/// What this program is, its version and build, and its licence. Shown without blocking; deletes itself. GUI thread.
QDialog* showAbout(const Theme& theme, QWidget* parent);

} // namespace chiron::desktop
