// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <utility>
#include <vector>

namespace chiron::desktop {

/// Where playback stands on the recording's time and how fast it goes. Everything that is shown follows its `moved`. GUI thread.
class PlaybackClock : public QObject {
    Q_OBJECT
public:
    static constexpr double kStep_s = 0.004; ///< one recorded picture: PlaybackTrack's samples

    explicit PlaybackClock(QObject* parent = nullptr);

    void setDuration(double duration_s);
    double duration_s() const noexcept { return m_duration_s; }
    double position_s() const noexcept { return m_position_s; }
    bool playing() const noexcept { return m_playing; }
    double speed() const noexcept { return m_speed; }

    void seek(double t_s); ///< clamped; playing goes on from there
    void step(int pictures); ///< pauses, then one picture on (or back)
    void play(); ///< from the beginning where it stands at the end
    void pause();
    void toggle() { m_playing ? pause() : play(); }
    void setSpeed(double times); ///< 0.1..4
    /// Stretches of the recording that playing leaps over; whoever seeks into one sees it. By time, not overlapping.
    void setLeapt(std::vector<std::pair<double, double>> spans_s) { m_leapt_s = std::move(spans_s); }
    /// Time that has passed for the person; the timer calls it, and tests.
    void advance(double real_s);

signals:
    void moved(double t_s);
    void playingChanged(bool playing);
    void durationChanged(double duration_s);

private:
    void setPlaying(bool playing);

    QTimer m_timer;
    QElapsedTimer m_sinceTick;
    double m_duration_s = 0.0;
    double m_position_s = 0.0;
    double m_speed = 1.0;
    std::vector<std::pair<double, double>> m_leapt_s; ///< begin, end
    bool m_playing = false;
};

} // namespace chiron::desktop
