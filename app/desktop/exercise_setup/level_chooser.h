// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/theme/theme.h"
#include "session/level_standing.h"

#include <QWidget>
#include <map>
#include <span>

class QButtonGroup;

namespace chiron::desktop {

class ChoiceTile;

/// Shows all levels of an exercise as tiles, with the person's standing at each and the recommended next
/// level as text.
/// Thread: GUI.
class LevelChooser final : public QWidget {
    Q_OBJECT
public:
    LevelChooser(const Theme& theme, const catalogue::Exercise& exercise, const std::string& language,
                 QWidget* parent = nullptr);

    int level() const;
    void setLevel(int level);
    /// `next`: the recommended level; 0 if every level is passed.
    void setStandings(std::span<const session::LevelStanding> standings, int next);

signals:
    void chosen(int level); ///< by the person, not by setLevel()

private:
    QButtonGroup* m_group;
    std::map<int, ChoiceTile*> m_tiles;
};

} // namespace chiron::desktop
