// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <utility>
#include <vector>

namespace chiron::desktop {

/// The position of playback in the recording, and its speed. Everything on the screen follows its `moved`
/// signal.
/// Thread: GUI.
class PlaybackClock : public QObject {
    Q_OBJECT
public:
    static constexpr double kStep_s = 0.004; ///< interval between samples of PlaybackTrack

    explicit PlaybackClock(QObject* parent = nullptr);

    void setDuration(double duration_s);
    double duration_s() const noexcept { return m_duration_s; }
    double position_s() const noexcept { return m_position_s; }
    bool playing() const noexcept { return m_playing; }
    double speed() const noexcept { return m_speed; }

    void seek(double t_s);   ///< clamped; playing continues from there
    void step(int pictures); ///< pauses, then moves by this many samples (negative: back)
    void play();             ///< starts from the beginning if the position is at the end
    void pause();
    void toggle() { m_playing ? pause() : play(); }
    void setSpeed(double times); ///< 0.1..4
    /// Sets spans of the recording that playing skips; seeking into one still shows it. They are in order of
    /// time and do not overlap.
    void setLeapt(std::vector<std::pair<double, double>> spans_s) { m_leapt_s = std::move(spans_s); }
    /// Advances by elapsed real time. The timer calls it, and so do tests.
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
    std::vector<std::pair<double, double>> m_leapt_s; ///< begin and end of each
    bool m_playing = false;
};

} // namespace chiron::desktop
