// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBitmap>
#include <QColor>
#include <QImage>
#include <QPainter>
#include <QRegion>

namespace chiron::tests {

/// Where a mask has a 1. A mask has black as the colour of its 0, which a bitmap would take for its 1.
inline QRegion regionOfMask(QImage mask) {
    mask.setColorTable({QColor(Qt::color0).rgba(), QColor(Qt::color1).rgba()});
    return QRegion(QBitmap::fromImage(mask));
}

/// Where an image that the program makes (an icon, a texture, a page) has exactly this colour.
inline QRegion regionOf(const QImage& image, const QColor& colour) {
    const QImage all = image.convertToFormat(QImage::Format_ARGB32);
    return regionOfMask(all.createMaskFromColor(colour.rgba()));
}

/// Where it is exactly as opaque as this: 0 where all that is behind it shows, 255 where nothing does.
inline QRegion regionOfAlpha(const QImage& image, int alpha) {
    const QImage all = image.convertToFormat(QImage::Format_Alpha8);
    return regionOfMask(all.createMaskFromColor(qRgba(0, 0, 0, alpha)));
}

/// The same shape in one colour.
inline QImage inOneColour(QImage image, const QColor& colour) {
    QPainter painter(&image);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(image.rect(), colour);
    return image;
}

inline int areaOf(const QRegion& region) {
    int pixels = 0;
    for (const QRect& rect : region)
        pixels += rect.width() * rect.height();
    return pixels;
}

} // namespace chiron::tests
