// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include "desktop/widgets/tile_button.h"

class QLabel;

namespace chiron::desktop {

/// A choice shown as a tile with two wrapping texts: its name and its state. Otherwise it is an ordinary
/// checkable button. Its accessible name contains both texts.
/// Thread: GUI.
class ChoiceTile final : public TileButton {
    Q_OBJECT
public:
    /// `icon`: the name of a Breeze icon; may be empty.
    ChoiceTile(const Theme& theme, const QString& title, const QString& words, const QString& icon = {},
               QWidget* parent = nullptr);

    void setWords(const QString& words);

private:
    QString m_title;
    QLabel* m_words;
};

} // namespace chiron::desktop
