// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "desktop/training/control_guide.h"

#include <QWidget>

namespace chiron::desktop {

/// A mouse seen from above, a handle seen from the side, or keys, with the used part in colour and arrows for
/// the direction. It is decorative; the text beside it says the same.
/// Thread: GUI.
class MousePictogram final : public QWidget {
    Q_OBJECT
public:
    MousePictogram(const Theme& theme, Pictogram picture, QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintStylus(QPainter& painter) const;
    void paintKeys(QPainter& painter) const;
    void paintMouse(QPainter& painter) const;
    void paintArrow(QPainter& painter, QPointF from, QPointF to) const;

    const Theme& m_theme;
    Pictogram m_picture;
};

} // namespace chiron::desktop
