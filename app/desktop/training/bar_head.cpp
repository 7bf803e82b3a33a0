// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/bar_head.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <utility>

namespace chiron::desktop {

namespace {
constexpr double kBesideGap_px = 8; // between name and words on one line
} // namespace

bool BarHead::fit(int width_px, const QStringList& words) {
    const QFontMetrics metrics(m_theme.font(TextStyle::label));
    int longest_px = 0;
    for (const QString& each : words)
        longest_px = std::max(longest_px, metrics.horizontalAdvance(each));
    const bool beside =
        metrics.horizontalAdvance(m_name) + m_theme.px(kBesideGap_px) + longest_px <= width_px;
    const int lines = beside || longest_px == 0 ? 1 : 2;
    return std::exchange(m_lines, lines) != lines;
}

int BarHead::lineHeight_px() const {
    return QFontMetrics(m_theme.font(TextStyle::label)).height();
}

int BarHead::height_px() const {
    return m_lines * lineHeight_px();
}

int BarHead::extra_px() const {
    return (m_lines - 1) * lineHeight_px();
}

void BarHead::paint(QPainter& painter, int width_px, const QString& words, Colour ink) const {
    painter.setFont(m_theme.font(TextStyle::label));
    const QRect head(0, 0, width_px, height_px());
    painter.setPen(m_theme.color(Colour::text));
    painter.drawText(head, Qt::AlignLeft | Qt::AlignTop, m_name);
    painter.setPen(m_theme.color(ink));
    painter.drawText(head, Qt::AlignRight | Qt::AlignBottom, words);
}

} // namespace chiron::desktop
