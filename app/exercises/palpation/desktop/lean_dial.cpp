// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/lean_dial.h"

#include "haptics/safety_display.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiron::desktop {

namespace {
constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr double kSide_px = 84;
} // namespace

double LeanDial::Lean::angle_deg() const {
    return kDegreesPerRadian * std::hypot(pitch_rad, roll_rad);
}

LeanDial::LeanDial(const Theme& theme, const QLocale& locale, int fingers, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale),
      m_fingers(std::clamp(fingers, 1, static_cast<int>(kMost))) {
    setAccessibleName(tr("Tilt of the fingertip platform"));
    setToolTip(accessibleName());
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QPointF LeanDial::dotOf(double pitch_rad, double roll_rad) {
    const double all_rad = std::hypot(pitch_rad, roll_rad);
    const double share =
        std::max({1.0, all_rad / haptics::kMaximumPitch_rad, std::abs(roll_rad) / haptics::kMaximumRoll_rad});
    return {roll_rad / share, pitch_rad / share};
}

QSize LeanDial::sizeHint() const {
    return {m_theme.px(200), m_theme.px(kSide_px)};
}

void LeanDial::setLean(int finger, double pitch_rad, double roll_rad, bool saturated) {
    if (finger < 0 || finger >= m_fingers || !std::isfinite(pitch_rad) || !std::isfinite(roll_rad))
        return;
    Lean& lean = m_lean[static_cast<std::size_t>(finger)];
    const bool said = lean.saturated != saturated ||
                      qRound(lean.angle_deg()) != qRound(Lean{pitch_rad, roll_rad, saturated}.angle_deg());
    lean = {pitch_rad, roll_rad, saturated};
    if (said)
        setAccessibleDescription(words());
    update();
}

QString LeanDial::words() const {
    QStringList all;
    for (int i = 0; i < m_fingers; ++i) {
        const Lean& lean = m_lean[static_cast<std::size_t>(i)];
        const QString angle = m_locale.toString(qRound(lean.angle_deg()));
        const QString text = lean.saturated ? tr("%1°, at its limit").arg(angle) : tr("%1°").arg(angle);
        all << (m_fingers > 1 ? tr("%1: %2").arg(m_locale.toString(i + 1), text) : text);
    }
    return all.join(QLatin1Char('\n'));
}

void LeanDial::paintField(QPainter& painter, const QRectF& field) const {
    painter.setPen(QPen(m_theme.color(Colour::borderStrong), m_theme.px(1)));
    painter.setBrush(m_theme.color(Colour::raised));
    // A circle with the radius of the largest lean, cut off at the largest roll.
    const double half = 0.5 * field.height();
    const QRectF circle(field.center().x() - half, field.top(), 2.0 * half, 2.0 * half);
    const double cut_deg = kDegreesPerRadian * std::acos(std::min(1.0, 0.5 * field.width() / half));
    QPainterPath outline;
    outline.arcMoveTo(circle, cut_deg);
    outline.arcTo(circle, cut_deg, 180.0 - 2.0 * cut_deg);
    outline.arcTo(circle, 180.0 + cut_deg, 180.0 - 2.0 * cut_deg);
    outline.closeSubpath();
    painter.drawPath(outline);
    painter.setPen(QPen(m_theme.color(Colour::grid), m_theme.px(1)));
    painter.drawLine(QPointF(field.center().x(), field.top()), QPointF(field.center().x(), field.bottom()));
    painter.drawLine(QPointF(field.left(), field.center().y()), QPointF(field.right(), field.center().y()));
}

void LeanDial::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double margin = m_theme.px(6);
    const double half = 0.5 * height() - margin;
    const double aside = half * haptics::kMaximumRoll_rad / haptics::kMaximumPitch_rad;
    const QRectF field(margin, margin, 2.0 * aside, 2.0 * half);
    paintField(painter, field);
    painter.setFont(m_theme.font(TextStyle::small));
    for (int i = 0; i < m_fingers; ++i) {
        const Lean& lean = m_lean[static_cast<std::size_t>(i)];
        const QPointF at =
            field.center() + half / haptics::kMaximumPitch_rad * dotOf(lean.pitch_rad, lean.roll_rad);
        const double r = m_theme.px(5);
        painter.setPen(QPen(m_theme.color(Colour::surface), m_theme.px(1)));
        painter.setBrush(m_theme.color(lean.saturated ? Colour::warning : Colour::seriesA));
        if (lean.saturated)
            painter.drawRect(QRectF(at.x() - r, at.y() - r, 2.0 * r, 2.0 * r));
        else
            painter.drawEllipse(at, r, r);
        if (m_fingers > 1) {
            painter.setPen(m_theme.color(Colour::text));
            // The dots of fingers that lean equally coincide, but their numbers do not: they are to the right
            // and left, and below for the second hand.
            const double wide = 3.0 * r;
            const QRectF number(i % 2 == 0 ? at.x() + r : at.x() - r - wide, i < 2 ? at.y() - wide : at.y(),
                                wide, wide);
            painter.drawText(number, Qt::AlignCenter | Qt::TextDontClip, m_locale.toString(i + 1));
        }
    }
    painter.setPen(m_theme.color(Colour::text));
    painter.setFont(m_theme.font(TextStyle::label));
    const QRectF text(field.right() + m_theme.px(12), 0, width() - field.right() - m_theme.px(12), height());
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
                     tr("Tilt").append(QLatin1Char('\n')).append(words()));
}

} // namespace chiron::desktop
