// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QString>
#include <QStringList>
#include <utility>

class QPainter;

namespace chiron::desktop {

/// The text over a bar: its name on the left and what it says on the right, or below each other where the
/// width has no room for both. Whether it has is decided by the longest words, so that nothing moves while
/// they change.
/// Thread: GUI.
class BarHead {
public:
    BarHead(const Theme& theme, QString name) : m_theme(theme), m_name(std::move(name)) {}

    /// Fits the text to a width. `words`: all that may be said. Returns true if the height has changed.
    bool fit(int width_px, const QStringList& words);
    int height_px() const;
    int extra_px() const; ///< height below the first line
    void paint(QPainter& painter, int width_px, const QString& words, Colour ink) const;

private:
    int lineHeight_px() const;

    const Theme& m_theme;
    QString m_name;
    int m_lines = 1;
};

} // namespace chiron::desktop
