// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>

class QPainter;

namespace chiron::report {

/// The style of text that is wrapped between words, and inside a word only if the word alone is wider than
/// the box. Measuring and drawing use the same layout, so text drawn into a box of the measured height fits.
/// Thread: GUI.
struct TextStyle {
    QFont font;
    QColor ink;
    Qt::Alignment side = Qt::AlignLeft;
};

double textHeight(const QString& words, const QFont& font, double width);
void drawText(QPainter& painter, const QRectF& box, const QString& words, const TextStyle& style);

} // namespace chiron::report
