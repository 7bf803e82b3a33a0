// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/playback/moment_words.h"
#include "desktop/playback/playback_clock.h"
#include "desktop/theme/theme.h"

#include <QLocale>
#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace chiron::desktop {

/// Controls of playback: play and pause, single steps, speed, and a display of the time.
/// Thread: GUI.
class TransportBar : public QWidget {
    Q_OBJECT
public:
    /// `pauses_s`: begin and end of each pause. Playing skips pauses unless the person wants to see them.
    TransportBar(const Theme& theme, const QLocale& locale, PlaybackClock& clock, MomentWords moments,
                 std::vector<std::pair<double, double>> pauses_s = {}, QWidget* parent = nullptr);

private:
    void buildButtons(class QLayout& row);
    void buildSpeed(class QLayout& row);
    void buildLeap(class QLayout& row, std::vector<std::pair<double, double>> pauses_s);
    void showPlaying(bool playing);
    void showTime();

    const Theme& m_theme;
    QLocale m_locale;
    PlaybackClock& m_clock;
    MomentWords m_moments;
    QPushButton* m_play = nullptr;
    QComboBox* m_speed = nullptr;
    QLabel* m_time = nullptr;
};

} // namespace chiron::desktop
