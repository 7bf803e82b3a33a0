// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/notice_painter.h"

#include <QCoreApplication>
#include <QFont>
#include <QPainter>
#include <algorithm>

namespace chiron::scene3d {

QString NoticePainter::sentence() {
    return QCoreApplication::translate("chiron::scene3d::NoticePainter",
                                       "The endoscope's picture is off at this level.");
}

void NoticePainter::paint(QPainter& painter, const QRectF& room, double unit) const {
    painter.fillRect(room, Qt::black);
    QFont font(m_setup.family);
    const QString text = sentence();
    constexpr int kFlags = Qt::AlignCenter | Qt::TextWordWrap;
    double size = 18.0 * m_setup.scale * unit; // reduced below if the room is too small
    for (; size > 8.0; size -= 1.0) {
        font.setPixelSize(std::max(1, int(size)));
        painter.setFont(font);
        if (room.contains(painter.boundingRect(room, kFlags, text)))
            break;
    }
    painter.setPen(Qt::white);
    painter.drawText(room, kFlags, text);
}

} // namespace chiron::scene3d
