// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text_box.h"

#include <QPainter>
#include <QTextLayout>
#include <QTextOption>
#include <cmath>

namespace chiron::report {

namespace {

// Breaks the words into lines of a width and returns the height of all lines.
double breakLines(QTextLayout& layout, Qt::Alignment side, double width) {
    QTextOption option(side);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    double top = 0.0;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        line.setPosition(QPointF(0.0, top));
        top += line.height();
    }
    layout.endLayout();
    return top;
}

} // namespace

double textHeight(const QString& words, const QFont& font, double width) {
    QTextLayout layout(words, font);
    return std::ceil(breakLines(layout, Qt::AlignLeft, width));
}

void drawText(QPainter& painter, const QRectF& box, const QString& words, const TextStyle& style) {
    QTextLayout layout(words, style.font);
    breakLines(layout, style.side, box.width());
    painter.setPen(style.ink);
    layout.draw(&painter, box.topLeft());
}

} // namespace chiron::report
