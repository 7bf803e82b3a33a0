// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/of_today.h"
#include "support/paint_outline.h"

#include <QAbstractButton>
#include <QFrame>
#include <qcustomplot.h>

namespace chiron::tests {

/// What the program's own widgets on a page paint, as lines of text, each under the name of the widget.
/// Frames and buttons are left out, because the style paints them, and so are plots.
inline QStringList paintedParts(QWidget& page) {
    QStringList lines;
    for (QWidget* part : page.findChildren<QWidget*>()) {
        QString name = QString::fromLatin1(part->metaObject()->className());
        if (!part->isVisible() || !name.startsWith(QLatin1String("chiron::")) ||
            qobject_cast<QFrame*>(part) || qobject_cast<QAbstractButton*>(part) ||
            qobject_cast<QCustomPlot*>(part))
            continue;
        OutlineDevice device(part->size(), [](const QString& text) { return withoutToday(text); });
        part->render(&device, QPoint(), QRegion(), {}); // neither background nor children
        const QStringList painted = device.take();
        if (painted.isEmpty())
            continue;
        if (!part->objectName().isEmpty())
            name += QLatin1Char('#') + withoutToday(part->objectName());
        lines << QStringLiteral("%1 %2x%3")
                     .arg(name.mid(name.lastIndexOf(QLatin1String("::")) + 2))
                     .arg(part->width())
                     .arg(part->height())
              << painted;
    }
    return lines;
}

} // namespace chiron::tests
