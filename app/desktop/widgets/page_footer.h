// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QVBoxLayout;

namespace chiron::desktop {

/// The strip below a ScrollPage that does not scroll. It holds the buttons of a form, so that they are in
/// sight in every window and at every scale. It is hidden while it holds nothing. Thread: GUI.
class PageFooter final : public QWidget {
    Q_OBJECT
public:
    /// `maximumWidth_px` as of the ScrollPage above it.
    PageFooter(const Theme& theme, int maximumWidth_px, QWidget* parent = nullptr);
    /// Takes these controls in place of the previous ones, which are deleted; null: none.
    void hold(QWidget* controls);

private:
    QVBoxLayout* m_room;
    QWidget* m_held = nullptr;
};

} // namespace chiron::desktop
