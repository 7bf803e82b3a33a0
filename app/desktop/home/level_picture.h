// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QSize>

class QPainter;

namespace chiron::desktop {

/// What a picture of a level is painted in.
struct PictureFrame {
    const Theme& theme;
    QSize size; ///< pixels
    bool objectShown = true; ///< the level lets it be seen; else it is dashed
};

/// The picture of a level, painted from its content as one exercise does. Decorative. GUI thread.
class LevelPicture {
public:
    explicit LevelPicture(const PictureFrame& frame) : m_theme(frame.theme), m_visible(frame.objectShown), m_size(frame.size) {}
    LevelPicture(const LevelPicture&) = delete;
    LevelPicture& operator=(const LevelPicture&) = delete;
    virtual ~LevelPicture() = default;

    /// On the ground that is painted already, from (0, 0) on.
    virtual void paint(QPainter& painter) const = 0;

protected:
    int width() const { return m_size.width(); }
    int height() const { return m_size.height(); }

    const Theme& m_theme;
    bool m_visible; ///< the object

private:
    QSize m_size;
};

} // namespace chiron::desktop
