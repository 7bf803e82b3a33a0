// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace chiron::desktop::form {

/// Enter presses the button of this page that has the focus, as Space does; anywhere else it does what it did. GUI thread.
void pressFocusedByEnter(QWidget* page);

} // namespace chiron::desktop::form
