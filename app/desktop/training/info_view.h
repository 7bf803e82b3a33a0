// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "haptics/display_state.h"
#include "session/level_cues.h"
#include "session/live_sample.h"

#include <QFrame>
#include <QLocale>
#include <cstdint>
#include <span>
#include <vector>

class QLabel;
class QVBoxLayout;

namespace chiron::desktop {

/// The frame of a panel with live measurements: its column, the elapsed time, what it says where the level
/// shows nothing, and the state of the loop. One derived class per kind of exercise fills it as far as the
/// level allows. By default a panel shows what a person watches while working; with details also single
/// components, coordinates, further plots and the state of the loop.
/// Thread: GUI.
class InfoView : public QFrame {
public:
    /// Call once per frame with the newest state and every sample since the previous frame.
    void show(const haptics::DisplayState& state, std::span<const session::LiveSample> samples);

    /// Shows or hides the details. Hidden details continue to be measured.
    void setDetailed(bool detailed);
    bool detailed() const noexcept { return m_detailed; }

    /// The number of parts that it can do without, because another part shows the same (a plot beside a bar).
    /// None with the details, which a person has asked for.
    int mayGiveUp() const { return m_detailed ? 0 : static_cast<int>(m_spare.size()); }
    /// Hides the first `parts` of them and shows the others. Hidden parts continue to be measured.
    void giveUp(int parts);
    /// Whether everything is recorded, and the force on time.
    static QString loopText(const haptics::DisplayState& state);

protected:
    /// The distances of the column, in logical pixels.
    struct Room {
        double edge_px = 8.0; ///< above and below the column
        double gap_px = 6.0;  ///< between its parts
    };
    InfoView(const Theme& theme, const Room& room, QWidget* parent);

    QVBoxLayout& parts() { return *m_column; } ///< the column
    /// Begins the column with the elapsed time in a line of its own. The caller makes the label; its text is
    /// written here.
    void addElapsed(QLabel* elapsed, Qt::Alignment alignment = {});
    /// Begins the column with `words` and the elapsed time beside them.
    void addHead(QLabel* words);
    /// Ends the column. `measures`: the panel shows measurements; otherwise it says that there are none.
    /// Where no plots fill the column, its parts stay together at the top.
    void addFoot(const session::LevelCues& cues, bool measures);
    /// Registers `part` as a detail. A panel starts without its details.
    void addDetail(QWidget* part);
    /// Registers `part` as one of those that it can do without; the first registered is the first hidden.
    void addSpare(QWidget* part) { m_spare.push_back(part); }

    /// Shows what moves: called in every frame.
    virtual void showMoving(const haptics::DisplayState& state,
                            std::span<const session::LiveSample> samples) = 0;
    /// Shows what is read, digits and words: called ten times per second, after showMoving().
    virtual void showReadings(const haptics::DisplayState& state) = 0;

private:
    void showLoop(const haptics::DisplayState& state);
    void placeLoopLine();

    const Theme& m_theme;
    QVBoxLayout* m_column;
    QLabel* m_elapsed = nullptr;
    std::int64_t m_worked_ms = 0; ///< since the first trial, without pauses
    int m_frame = 0;
    std::vector<QWidget*> m_details;
    std::vector<QWidget*> m_spare;
    bool m_detailed = false;
    QLabel* m_loop = nullptr;
    bool m_lost = false; ///< samples were lost; shown with or without details
};

} // namespace chiron::desktop
