// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/playback/moment_words.h"
#include "desktop/theme/theme.h"
#include "session/playback_track.h"

#include <QAbstractSlider>
#include <vector>

namespace chiron::desktop {

/// Shows the recording's time as a bar with a handle, trials, hatched pauses, and ticks for marks and
/// comments (penalties as triangles, answers as flags, comments as squares below). For keyboard and screen
/// reader it is a slider: arrow keys step by one sample, Page keys by one second, and Home and End jump to
/// the ends. Its values are milliseconds.
/// Thread: GUI.
class Scrubber : public QAbstractSlider {
    Q_OBJECT
public:
    explicit Scrubber(const Theme& theme, QWidget* parent = nullptr);

    /// Copies what it draws.
    void setTrack(const session::PlaybackTrack& track, const std::string& exercise, MomentWords moments);
    void setComments(std::vector<double> moments_s);
    void setPosition(double t_s);
    QSize sizeHint() const override;
    /// Horizontal position of a time, in logical pixels.
    double xOf(double t_s) const;

signals:
    void seekAsked(double t_s);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    QRectF groove() const;
    double timeAt(double x) const;
    void paintTrials(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintHandle(QPainter& painter) const;

    const Theme& m_theme;
    std::string m_exercise; ///< selects the texts
    MomentWords m_moments;
    double m_duration_s = 0.0;
    double m_position_s = 0.0;
    std::vector<session::PlaybackTrial> m_trials;
    std::vector<session::PlaybackSpan> m_paused;
    std::vector<session::PlaybackMark> m_marks; ///< without contacts, which are too many to distinguish
    std::vector<double> m_comments_s;
};

} // namespace chiron::desktop
