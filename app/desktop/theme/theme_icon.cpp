// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/theme/theme.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>

namespace chiron::desktop {

namespace {

/// Breeze has one drawing per size and kind; the plain 22 px drawings are those made for buttons.
QString fileOf(const QString& name) {
    for (const char* kind : {"actions/22", "actions/32", "status/22", "devices/22", "places/22", "apps/22",
                             "actions/16", "status/16"}) {
        const QString path =
            QStringLiteral("/usr/share/icons/breeze/%1/%2.svg").arg(QLatin1String(kind), name);
        if (QFile::exists(path))
            return path;
    }
    return {};
}

QPixmap dot(const QSize& size, const QColor& ink) {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(ink);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(
        QRectF(size.width() * 0.3, size.height() * 0.3, size.width() * 0.4, size.height() * 0.4));
    return pixmap;
}

/// Draws a Breeze shape in one colour, because its own colours belong to a desktop's palette, not to this
/// theme. It draws on demand in the requested size, because a screen has many icons and most of their sizes
/// and modes are never shown.
class InkedIcon final : public QIconEngine {
public:
    InkedIcon(QString name, QColor ink, QColor disabled)
        : m_name(std::move(name)), m_ink(ink), m_disabled(disabled) {}

    QIconEngine* clone() const override { return new InkedIcon(m_name, m_ink, m_disabled); }
    bool isNull() override { return false; }
    QSize actualSize(const QSize& size, QIcon::Mode, QIcon::State) override { return size; }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override {
        const QColor ink = mode == QIcon::Disabled ? m_disabled : m_ink;
        const QString key = QStringLiteral("chiron-icon/%1/%2/%3x%4")
                                .arg(m_name, ink.name())
                                .arg(size.width())
                                .arg(size.height());
        QPixmap pixmap;
        if (QPixmapCache::find(key, &pixmap))
            return pixmap;
        const QString file = fileOf(m_name);
        if (!file.isEmpty())
            pixmap = QIcon(file).pixmap(size, 1.0);
        pixmap = pixmap.isNull() ? dot(size, ink) : inked(pixmap, ink);
        QPixmapCache::insert(key, pixmap);
        return pixmap;
    }

    void paint(QPainter* painter, const QRect& area, QIcon::Mode mode, QIcon::State state) override {
        const qreal ratio = painter->device()->devicePixelRatio();
        QPixmap drawn = pixmap(area.size() * ratio, mode, state);
        drawn.setDevicePixelRatio(ratio);
        painter->drawPixmap(area, drawn);
    }

private:
    static QPixmap inked(QPixmap pixmap, const QColor& ink) {
        QPainter painter(&pixmap);
        painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
        painter.fillRect(pixmap.rect(), ink);
        return pixmap;
    }

    QString m_name;
    QColor m_ink;
    QColor m_disabled;
};

} // namespace

QIcon Theme::icon(const QString& name, Colour ink) const {
    return QIcon(new InkedIcon(name, color(ink), color(Colour::muted)));
}

} // namespace chiron::desktop
