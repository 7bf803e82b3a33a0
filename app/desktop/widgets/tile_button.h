// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QPushButton>

class QHBoxLayout;

namespace chiron::desktop {

/// A button that contains labels and is as high as their wrapped text needs at its width, which an ordinary
/// push button with a layout does not support. Set an accessible name. Call seal() after adding labels, so
/// that they let the mouse through.
/// Thread: GUI.
class TileButton : public QPushButton {
    Q_OBJECT
public:
    explicit TileButton(const Theme& theme, QWidget* parent = nullptr);

    QHBoxLayout* row() const noexcept { return m_row; }
    /// Call it after the labels were added: makes the whole tile act as the button.
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
