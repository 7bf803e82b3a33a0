// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include "desktop/widgets/tile_button.h"

class QLabel;

namespace chiron::desktop {

/// A choice as a tile of two texts that wrap: what it is, and how it stands. An ordinary checkable button otherwise; its
/// accessible name is both texts. GUI thread.
class ChoiceTile final : public TileButton {
    Q_OBJECT
public:
    /// `icon`: a Breeze name, may be empty.
    ChoiceTile(const Theme& theme, const QString& title, const QString& words, const QString& icon = {}, QWidget* parent = nullptr);

    void setWords(const QString& words);

private:
    QString m_title;
    QLabel* m_words;
};

} // namespace chiron::desktop
