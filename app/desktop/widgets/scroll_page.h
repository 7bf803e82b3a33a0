// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QScrollArea>

class QVBoxLayout;

namespace chiron::desktop {

/// A page that scrolls if the window is small or the scale is large, with the common margins and maximum
/// width of all pages. Put the screen's parts into column(). The scroll bar follows the keyboard focus.
class ScrollPage : public QScrollArea {
    Q_OBJECT
public:
    /// `maximumWidth_px` at 100 %; 0: the full width of the window.
    explicit ScrollPage(const Theme& theme, int maximumWidth_px = 1200, QWidget* parent = nullptr);
    QVBoxLayout* column() const { return m_column; }

protected:
    bool focusNextPrevChild(bool next) override;

private:
    QVBoxLayout* m_column;
};

} // namespace chiron::desktop
