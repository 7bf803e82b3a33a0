// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/scene_note_painter.h"

#include "core/units.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {
// In logical pixels at scale 1.
constexpr double kSign = 72.0;
constexpr double kTitle = 26.0;
constexpr double kWords = 16.0;
constexpr double kLeastWords = 8.0; // below this nobody reads anything
constexpr double kGap = 12.0;
// A line may cover this share of the height before a smaller font is used.
constexpr double kPlateShare = 0.12;
constexpr int kVeil = 168; // of 255: the scene remains recognisable but clearly inactive
constexpr int kWrapped = Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap;

void paintBars(QPainter& painter, const QRectF& sign) {
    painter.setBrush(Qt::white);
    const double wide = 0.28 * sign.width();
    painter.drawRect(QRectF(sign.left() + 0.12 * sign.width(), sign.top(), wide, sign.height()));
    painter.drawRect(QRectF(sign.right() - 0.12 * sign.width() - wide, sign.top(), wide, sign.height()));
}

void paintOctagon(QPainter& painter, const QRectF& sign, const QColor& colour) {
    QPolygonF octagon;
    for (int i = 0; i < 8; ++i) {
        const double angle = core::kPi * (i + 0.5) / 4.0;
        octagon << sign.center() + 0.54 * sign.width() * QPointF(std::cos(angle), std::sin(angle));
    }
    painter.setPen(QPen(Qt::white, 0.06 * sign.width()));
    painter.setBrush(colour);
    painter.drawPolygon(octagon);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawRect(
        QRectF(sign.center() - QPointF(0.16, 0.16) * sign.width(), QSizeF(0.32, 0.32) * sign.width()));
}

} // namespace

QFont SceneNotePainter::font(double size_px, bool bold) const {
    QFont font(m_setup.family);
    font.setPixelSize(std::max(1, int(size_px)));
    font.setBold(bold);
    return font;
}

void SceneNotePainter::paint(QPainter& painter, const QRectF& room, double unit,
                             const SceneNote& note) const {
    if (note.kind == SceneNote::Kind::none)
        return;
    painter.save();
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    painter.setPen(Qt::NoPen);
    if (note.kind == SceneNote::Kind::said)
        paintPlate(painter, room, unit * m_setup.scale, note);
    else
        paintVeil(painter, room, unit * m_setup.scale, note);
    painter.restore();
}

void SceneNotePainter::paintVeil(QPainter& painter, const QRectF& room, double unit,
                                 const SceneNote& note) const {
    painter.fillRect(room, QColor(0, 0, 0, kVeil));
    const QRectF lines = room.adjusted(0.08 * room.width(), 0.0, -0.08 * room.width(), 0.0);
    const auto high = [&lines](const QFont& font, const QString& text) {
        return QFontMetricsF(font).boundingRect(lines, kWrapped, text).height();
    };
    // In a small scene the sign gives way first, then the gaps, then the title, and the rest of the text
    // last: nothing is cut.
    double title_px = kTitle * unit, words_px = kWords * unit, gap = kGap * unit;
    QFont large = font(title_px, true), small = font(words_px, false);
    double titleHigh = high(large, note.title), wordsHigh = high(small, note.words);
    const double least_px = kLeastWords * unit;
    while (titleHigh + wordsHigh + 2.0 * gap > room.height() && words_px > least_px) {
        if (gap > 0.25 * kGap * unit)
            gap -= unit;
        else if (title_px > words_px)
            title_px = std::max(words_px, title_px - unit);
        else
            title_px = words_px = std::max(least_px, words_px - unit);
        large = font(title_px, true);
        small = font(words_px, false);
        titleHigh = high(large, note.title);
        wordsHigh = high(small, note.words);
    }
    const double sign = std::clamp(room.height() - titleHigh - wordsHigh - 4.0 * gap, 0.0, kSign * unit);
    double y = room.center().y() - 0.5 * (sign + titleHigh + wordsHigh + 2.0 * gap);
    const QRectF spot(room.center().x() - 0.5 * sign, y, sign, sign);
    if (note.kind == SceneNote::Kind::paused)
        paintBars(painter, spot);
    else
        paintOctagon(painter, spot, m_setup.colours.stop);
    y += sign + gap;
    painter.setPen(Qt::white);
    painter.setFont(large);
    painter.drawText(QRectF(lines.left(), y, lines.width(), titleHigh), kWrapped, note.title);
    painter.setFont(small);
    painter.drawText(QRectF(lines.left(), y + titleHigh + gap, lines.width(), wordsHigh), kWrapped,
                     note.words);
}

void SceneNotePainter::paintPlate(QPainter& painter, const QRectF& room, double unit,
                                  const SceneNote& note) const {
    const double gap = kGap * unit;
    const QRectF lines = room.adjusted(2.0 * gap, 2.0 * gap, -2.0 * gap, -2.0 * gap);
    QFont large = font(kTitle * unit, true);
    if (QFontMetricsF(large).boundingRect(lines, kWrapped, note.title).height() > kPlateShare * room.height())
        large = font(kWords * unit, true); // the scene that the text refers to lies under it
    const QRectF text = QFontMetricsF(large).boundingRect(lines, kWrapped, note.title);
    const QRectF plate = text.adjusted(-1.5 * gap, -0.7 * gap, 1.5 * gap, 0.7 * gap);
    QColor ground = m_setup.colours.background;
    ground.setAlpha(236);
    painter.setPen(QPen(m_setup.colours.ink, unit));
    painter.setBrush(ground);
    painter.drawRoundedRect(plate, gap, gap);
    painter.setFont(large);
    painter.setPen(m_setup.colours.ink);
    painter.drawText(text, kWrapped, note.title);
}

} // namespace chiron::scene3d
