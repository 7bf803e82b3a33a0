// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QSize>

class QPainter;

namespace chiron::desktop {

/// The context in which a picture of a level is painted.
struct PictureFrame {
    const Theme& theme;
    QSize size;              ///< in pixels
    bool objectShown = true; ///< the level shows the object; otherwise it is drawn dashed
};

/// Paints a picture of a level from the level's content, in the way of its exercise. The picture is
/// decorative.
/// Thread: GUI.
class LevelPicture {
public:
    explicit LevelPicture(const PictureFrame& frame)
        : m_theme(frame.theme), m_visible(frame.objectShown), m_size(frame.size) {}
    LevelPicture(const LevelPicture&) = delete;
    LevelPicture& operator=(const LevelPicture&) = delete;
    virtual ~LevelPicture() = default;

    /// Paints the picture from (0, 0) over a background that is already painted.
    virtual void paint(QPainter& painter) const = 0;

protected:
    int width() const { return m_size.width(); }
    int height() const { return m_size.height(); }

    const Theme& m_theme;
    bool m_visible; ///< whether the object is visible

private:
    QSize m_size;
};

} // namespace chiron::desktop
