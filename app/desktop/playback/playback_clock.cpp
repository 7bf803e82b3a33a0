// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/playback_clock.h"

#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr int kPicture_ms = 16;
// After a stall of the window, playback must not skip what was to be seen.
constexpr double kLongestJump_s = 0.25;
} // namespace

PlaybackClock::PlaybackClock(QObject* parent) : QObject(parent) {
    m_timer.setInterval(kPicture_ms);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this,
            [this] { advance(1e-9 * static_cast<double>(m_sinceTick.nsecsElapsed())); });
}

void PlaybackClock::setDuration(double duration_s) {
    m_duration_s = std::max(0.0, duration_s);
    emit durationChanged(m_duration_s);
    seek(m_position_s);
}

void PlaybackClock::seek(double t_s) {
    m_position_s = std::clamp(t_s, 0.0, m_duration_s);
    emit moved(m_position_s);
}

void PlaybackClock::step(int pictures) {
    pause();
    seek(m_position_s + pictures * kStep_s);
}

void PlaybackClock::setPlaying(bool playing) {
    if (m_playing == playing)
        return;
    m_playing = playing;
    if (playing) {
        m_sinceTick.start();
        m_timer.start();
    } else {
        m_timer.stop();
    }
    emit playingChanged(playing);
}

void PlaybackClock::play() {
    if (m_duration_s <= 0.0)
        return;
    if (m_position_s >= m_duration_s)
        seek(0.0);
    setPlaying(true);
}

void PlaybackClock::pause() {
    setPlaying(false);
}

void PlaybackClock::setSpeed(double times) {
    m_speed = std::clamp(times, 0.1, 4.0);
}

void PlaybackClock::advance(double real_s) {
    if (!m_playing)
        return;
    m_sinceTick.start();
    double next_s = m_position_s + m_speed * std::min(real_s, kLongestJump_s);
    for (const auto& [begin_s, end_s] : m_leapt_s)
        if (next_s >= begin_s && next_s < end_s)
            next_s = end_s;
    seek(next_s);
    if (m_position_s >= m_duration_s)
        setPlaying(false);
}

} // namespace chiron::desktop
