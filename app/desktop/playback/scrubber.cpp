// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/scrubber.h"

#include "desktop/playback/mark_look.h"
#include "desktop/playback/playback_clock.h"
#include "session_report/mark_words.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace mark_kinds = session::mark_kinds;

Scrubber::Scrubber(const Theme& theme, QWidget* parent) : QAbstractSlider(parent), m_theme(theme) {
    setOrientation(Qt::Horizontal);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setSingleStep(qRound(1e3 * PlaybackClock::kStep_s));
    setPageStep(1000);
    setAccessibleName(tr("Position in the recording"));
    // Only a person's input requests a seek, because setPosition() blocks the signal.
    connect(this, &QAbstractSlider::valueChanged, this,
            [this](int value_ms) { emit seekAsked(1e-3 * value_ms); });
}

void Scrubber::setTrack(const session::PlaybackTrack& track, const std::string& exercise,
                        MomentWords moments) {
    m_exercise = exercise;
    m_moments = std::move(moments);
    m_duration_s = track.duration_s;
    m_trials = track.trials;
    m_paused = track.paused;
    m_marks.clear();
    for (const session::PlaybackMark& mark : track.marks)
        if (mark.kind != mark_kinds::kContact && mark.kind != mark_kinds::kPaused &&
            mark.kind != mark_kinds::kTrialStarted)
            m_marks.push_back(mark);
    const QSignalBlocker quiet(this);
    setRange(0, qRound(1e3 * m_duration_s));
    update();
}

void Scrubber::setComments(std::vector<double> moments_s) {
    m_comments_s = std::move(moments_s);
    update();
}

void Scrubber::setPosition(double t_s) {
    m_position_s = t_s;
    const QSignalBlocker quiet(this);
    setValue(qRound(1e3 * t_s));
    setAccessibleDescription(m_moments.at(t_s)); // the value alone would be read aloud in milliseconds
}

QSize Scrubber::sizeHint() const {
    return {m_theme.px(320), m_theme.px(52)};
}

QRectF Scrubber::groove() const {
    const double side = m_theme.px(12);
    return QRectF(side, 0.5 * height() - m_theme.px(4), std::max(1.0, width() - 2.0 * side), m_theme.px(8));
}

double Scrubber::xOf(double t_s) const {
    return groove().left() + (m_duration_s > 0.0 ? t_s / m_duration_s : 0.0) * groove().width();
}

double Scrubber::timeAt(double x) const {
    return std::clamp((x - groove().left()) / groove().width(), 0.0, 1.0) * m_duration_s;
}

void Scrubber::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        emit seekAsked(timeAt(event->position().x()));
}

void Scrubber::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton)
        emit seekAsked(timeAt(event->position().x()));
}

void Scrubber::keyPressEvent(QKeyEvent* event) {
    // Steps from the exact position, not from the rounded value: samples are 4 ms apart, and positions lie
    // between milliseconds.
    const double page_s = 1e-3 * pageStep();
    switch (event->key()) {
    case Qt::Key_PageUp:
        emit seekAsked(m_position_s + page_s);
        return;
    case Qt::Key_PageDown:
        emit seekAsked(m_position_s - page_s);
        return;
    default:
        event->ignore(); // arrows, Home, End and Space belong to the screen, wherever the focus is
    }
}

bool Scrubber::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QAbstractSlider::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QString text = m_moments.at(timeAt(help->pos().x()));
    for (const session::PlaybackMark& mark : m_marks)
        if (std::abs(xOf(mark.t_s) - help->pos().x()) <= m_theme.px(6))
            text += QLatin1Char('\n') + session_report::markText(mark, m_exercise, locale());
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

void Scrubber::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.color(Colour::border));
    painter.drawRoundedRect(groove(), m_theme.px(3), m_theme.px(3));
    paintTrials(painter);
    paintMarks(painter);
    paintHandle(painter);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_theme.color(Colour::focus), m_theme.px(2)));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), m_theme.px(6), m_theme.px(6));
    }
}

void Scrubber::paintTrials(QPainter& painter) const {
    const QRectF bar = groove();
    const double gap = m_theme.px(1);
    painter.setFont(m_theme.font(TextStyle::small));
    for (const session::PlaybackTrial& trial : m_trials) {
        const QRectF span(xOf(trial.start_s), bar.top(),
                          std::max(1.0, xOf(trial.end_s) - xOf(trial.start_s) - gap), bar.height());
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_theme.color(Colour::seriesA));
        painter.drawRect(span);
        // There is no number if there is only one trial.
        const QString number = m_trials.size() > 1 ? locale().toString(trial.index + 1) : QString();
        if (painter.fontMetrics().horizontalAdvance(number) + m_theme.px(4) < span.width()) {
            painter.setPen(m_theme.color(Colour::muted));
            painter.drawText(QRectF(span.left(), bar.bottom() + m_theme.px(1), span.width(), m_theme.px(16)),
                             Qt::AlignHCenter, number);
        }
    }
    for (const session::PlaybackSpan& pause : m_paused) {
        const QRectF span(QPointF(xOf(pause.begin_s), bar.top() - gap),
                          QPointF(xOf(pause.end_s), bar.bottom() + gap));
        painter.setPen(QPen(m_theme.color(Colour::borderStrong), gap));
        painter.setBrush(m_theme.color(Colour::surface));
        painter.drawRect(span);
        painter.setBrush(QBrush(m_theme.color(Colour::muted), Qt::BDiagPattern));
        painter.drawRect(span);
    }
}

void Scrubber::paintMarks(QPainter& painter) const {
    const QRectF bar = groove();
    const double size = m_theme.px(5);
    const double top = bar.top() - m_theme.px(2);
    for (const session::PlaybackMark& mark : m_marks) {
        const double x = xOf(mark.t_s);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_theme.color(markColour(mark.kind)));
        if (session::isPenalty(mark.kind)) {
            painter.drawPolygon(QPolygonF(
                {QPointF(x, top), QPointF(x - size, top - 1.8 * size), QPointF(x + size, top - 1.8 * size)}));
        } else if (mark.kind.flag) {
            painter.drawRect(QRectF(x - 0.15 * size, top - 2.2 * size, 0.3 * size, 2.2 * size));
            painter.drawRect(QRectF(x, top - 2.2 * size, 1.3 * size, 1.1 * size));
        } else {
            painter.drawRect(QRectF(x - 0.2 * size, top - 1.4 * size, 0.4 * size, 1.4 * size));
        }
    }
    painter.setBrush(m_theme.color(Colour::warning));
    for (const double t_s : m_comments_s)
        painter.drawRoundedRect(QRectF(xOf(t_s) - size, bar.bottom() + m_theme.px(2), 2 * size, 1.6 * size),
                                1, 1);
}

void Scrubber::paintHandle(QPainter& painter) const {
    const double radius = m_theme.px(8);
    painter.setPen(QPen(m_theme.color(Colour::surface), m_theme.px(2)));
    painter.setBrush(m_theme.color(Colour::text));
    painter.drawEllipse(QPointF(xOf(m_position_s), groove().center().y()), radius, radius);
}

} // namespace chiron::desktop
