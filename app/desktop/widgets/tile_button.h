// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QPushButton>

class QHBoxLayout;

namespace chiron::desktop {

/// A button with labels of its own inside, as high as their wrapped words need at its width: an ordinary push button knows
/// nothing of a layout in it. Set an accessible name; labels added later must let the mouse through (seal()). GUI thread.
class TileButton : public QPushButton {
    Q_OBJECT
public:
    explicit TileButton(const Theme& theme, QWidget* parent = nullptr);

    QHBoxLayout* row() const noexcept { return m_row; }
    /// After the labels were put in: the whole tile is the button.
    void seal();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void keepWords();

    QHBoxLayout* m_row;
};

} // namespace chiron::desktop
