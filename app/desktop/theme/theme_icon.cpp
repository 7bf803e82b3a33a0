// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/theme/theme.h"

#include <QFile>
#include <QPainter>
#include <QPixmap>

namespace chiron::desktop {

namespace {

/// Breeze keeps one drawing for each size and kind; the plain 22 px drawings are the ones made for buttons.
QString fileOf(const QString& name) {
    for (const char* kind : {"actions/22", "actions/32", "status/22", "devices/22", "places/22", "apps/22", "actions/16", "status/16"}) {
        const QString path = QStringLiteral("/usr/share/icons/breeze/%1/%2.svg").arg(QLatin1String(kind), name);
        if (QFile::exists(path))
            return path;
    }
    return {};
}

QPixmap dot(int size, const QColor& ink) {
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(ink);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(QRectF(size * 0.3, size * 0.3, size * 0.4, size * 0.4));
    return pixmap;
}

/// The same shape in one ink: Breeze's own colours belong to a desktop's palette, not to ours.
QPixmap inked(QPixmap pixmap, const QColor& ink) {
    QPainter painter(&pixmap);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(pixmap.rect(), ink);
    return pixmap;
}

} // namespace

QIcon Theme::icon(const QString& name, Colour ink) const {
    const QString file = fileOf(name);
    const QIcon source = file.isEmpty() ? QIcon() : QIcon(file);
    QIcon icon;
    for (const int size : {px(22), 2 * px(22)}) {
        QPixmap pixmap = source.pixmap(QSize(size, size));
        if (pixmap.isNull())
            pixmap = dot(size, color(ink));
        icon.addPixmap(inked(pixmap, color(ink)));
        icon.addPixmap(inked(pixmap, color(Colour::muted)), QIcon::Disabled);
    }
    return icon;
}

} // namespace chiron::desktop
