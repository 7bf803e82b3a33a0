// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPageSize>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainterPath>
#include <QPdfWriter>
#include <QStringList>
#include <QTextItem>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace chiron::tests {

/// Takes down what is painted as lines of text: words with place, letters and colour; shapes with pen, brush,
/// clip, corners. Places are in device units, to a tenth. A shape of more than four corners is told by their
/// number, box, centre of weight (the later the heavier) and the length of its line; so is a run of four or
/// more shapes of one look; a picture by its size and colours. Words of one look stand on one line.
class OutlineEngine final : public QPaintEngine {
public:
    /// What a text becomes that is of today; where it lies from left to right is then left out.
    using Mask = std::function<QString(QString)>;

    explicit OutlineEngine(Mask mask = {}) : QPaintEngine(AllFeatures), m_mask(std::move(mask)) {}

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }

    QStringList take() {
        flush();
        m_look.clear();
        return std::exchange(m_lines, {});
    }
    void say(const QString& line) {
        flush();
        m_look.clear();
        m_lines << line;
    }

    void updateState(const QPaintEngineState& now) override {
        const auto dirty = now.state();
        if (dirty & DirtyTransform)
            m_toDevice = now.transform();
        if (dirty & DirtyPen)
            m_pen = now.pen();
        if (dirty & DirtyBrush)
            m_brush = now.brush();
        if (dirty & DirtyOpacity)
            m_opacity = now.opacity();
        if (dirty & DirtyCompositionMode)
            m_mode = now.compositionMode();
        if (dirty & DirtyClipEnabled)
            m_clipped = now.isClipEnabled();
        if (dirty & DirtyClipPath)
            clip(now.clipOperation(), now.clipPath().boundingRect());
        if (dirty & DirtyClipRegion)
            clip(now.clipOperation(), QRectF(now.clipRegion().boundingRect()));
    }

    void drawLines(const QLineF* lines, int count) override {
        for (int i = 0; i < count; ++i)
            shape("line", {lines[i].p1(), lines[i].p2()}, false);
    }
    void drawLines(const QLine* lines, int count) override {
        for (int i = 0; i < count; ++i)
            shape("line", {lines[i].p1(), lines[i].p2()}, false);
    }
    void drawRects(const QRectF* rects, int count) override {
        for (int i = 0; i < count; ++i)
            shape("rect", {rects[i].topLeft(), rects[i].bottomRight()}, true);
    }
    void drawRects(const QRect* rects, int count) override {
        for (int i = 0; i < count; ++i)
            shape("rect", {QRectF(rects[i]).topLeft(), QRectF(rects[i]).bottomRight()}, true);
    }
    void drawEllipse(const QRectF& rect) override {
        shape("ellipse", {rect.topLeft(), rect.bottomRight()}, true);
    }
    void drawEllipse(const QRect& rect) override { drawEllipse(QRectF(rect)); }
    void drawPoints(const QPointF* points, int count) override {
        shape("points", {points, points + count}, false);
    }
    void drawPoints(const QPoint* points, int count) override {
        shape("points", {points, points + count}, false);
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        shape(mode == PolylineMode ? "polyline" : "polygon", {points, points + count}, mode != PolylineMode);
    }
    void drawPolygon(const QPoint* points, int count, PolygonDrawMode mode) override {
        shape(mode == PolylineMode ? "polyline" : "polygon", {points, points + count}, mode != PolylineMode);
    }
    void drawPath(const QPainterPath& path) override {
        std::vector<QPointF> points;
        for (int i = 0; i < path.elementCount(); ++i)
            points.push_back(path.elementAt(i));
        shape("path", points, true);
    }
    void drawPixmap(const QRectF& to, const QPixmap& pixmap, const QRectF&) override {
        picture("pixmap", to, pixmap.toImage());
    }
    void drawTiledPixmap(const QRectF& to, const QPixmap& pixmap, const QPointF&) override {
        picture("tiles", to, pixmap.toImage());
    }
    void drawImage(const QRectF& to, const QImage& image, const QRectF&, Qt::ImageConversionFlags) override {
        picture("image", to, image);
    }
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        const QFont font = item.font();
        Item one;
        one.kind = QStringLiteral("words");
        one.look = QStringLiteral("%1 %2 %3%4 %5%6")
                       .arg(font.family())
                       .arg(font.pixelSize() > 0 ? font.pixelSize() : font.pointSizeF())
                       .arg(font.weight())
                       .arg(font.italic() ? QStringLiteral("i") : QString(),
                            m_pen.color().name(QColor::HexArgb), around());
        one.points = {m_toDevice.map(at)};
        const QString text = m_mask ? m_mask(item.text()) : item.text();
        one.text = QLatin1Char('"') + text + QStringLiteral("\" ");
        if (text == item.text())
            one.text += number(one.points[0].x()) + QLatin1Char(',');
        one.text += number(one.points[0].y());
        if (const double turned = std::atan2(m_toDevice.m12(), m_toDevice.m11()); std::abs(turned) > 1e-6)
            one.text += QStringLiteral(" turned %1").arg(qRound(turned * 180.0 / M_PI));
        add(one);
    }

private:
    struct Item {
        QString kind, look, text; ///< text: of words and pictures
        std::vector<QPointF> points;
    };

    static QString number(double x) { return QString::number(std::abs(x) < 0.05 ? 0.0 : x, 'f', 1); }
    static QString place(const QPointF& p) { return number(p.x()) + QLatin1Char(',') + number(p.y()); }
    static QString box(const QRectF& r) {
        return QStringLiteral("%1 %2x%3").arg(place(r.topLeft()), number(r.width()), number(r.height()));
    }

    void clip(Qt::ClipOperation operation, const QRectF& to) {
        const QRectF device = m_toDevice.mapRect(to);
        m_clip = operation == Qt::NoClip                              ? QRectF()
                 : operation == Qt::IntersectClip && !m_clip.isNull() ? m_clip & device
                                                                      : device;
        m_clipped = operation != Qt::NoClip;
    }
    QString around() const {
        QString text;
        if (m_clipped && !m_clip.isNull())
            text += QStringLiteral(" clip ") + box(m_clip);
        if (m_opacity < 1.0)
            text += QStringLiteral(" opacity %1").arg(m_opacity, 0, 'f', 2);
        if (m_mode != QPainter::CompositionMode_SourceOver)
            text += QStringLiteral(" mode %1").arg(m_mode);
        return text;
    }
    QString look(bool filled) const {
        QString text = QStringLiteral("no pen");
        if (m_pen.style() != Qt::NoPen) {
            const double scale = m_pen.isCosmetic() ? 1.0 : std::sqrt(std::abs(m_toDevice.determinant()));
            text = QStringLiteral("pen %1 %2")
                       .arg(m_pen.color().name(QColor::HexArgb))
                       .arg(m_pen.widthF() * scale, 0, 'f', 2);
            if (m_pen.style() != Qt::SolidLine)
                text += QStringLiteral(" style %1").arg(m_pen.style());
            for (const double dash :
                 m_pen.style() == Qt::CustomDashLine ? m_pen.dashPattern() : QList<double>())
                text += QStringLiteral("/%1").arg(dash, 0, 'f', 1);
        }
        if (filled && m_brush.style() != Qt::NoBrush) {
            text += QStringLiteral(" fill ") + m_brush.color().name(QColor::HexArgb);
            if (m_brush.style() != Qt::SolidPattern)
                text += QStringLiteral(" pattern %1").arg(m_brush.style());
            if (const QGradient* gradient = m_brush.gradient())
                for (const QGradientStop& stop : gradient->stops())
                    text += QStringLiteral("/%1 %2")
                                .arg(stop.first, 0, 'f', 2)
                                .arg(stop.second.name(QColor::HexArgb));
        }
        return text + around();
    }
    void shape(const char* kind, std::vector<QPointF> points, bool filled) {
        if (points.empty())
            return;
        for (QPointF& p : points)
            p = m_toDevice.map(p);
        add({QLatin1String(kind), look(filled), {}, std::move(points)});
    }
    void picture(const char* kind, const QRectF& to, const QImage& image) {
        add({QLatin1String(kind),
             QStringLiteral("picture") + around(),
             QStringLiteral("%1x%2 at %3%4")
                 .arg(image.width())
                 .arg(image.height())
                 .arg(box(m_toDevice.mapRect(to)), coloursOf(image)),
             {}});
    }
    /// Where a picture has few colours, how many pixels have each, and where they lie on average; else its
    /// mean colour.
    static QString coloursOf(const QImage& picture) {
        constexpr std::size_t kFew = 12;
        const QImage image = picture.convertToFormat(QImage::Format_ARGB32);
        struct Sum {
            double count = 0.0, x = 0.0, y = 0.0;
        };
        std::map<QRgb, Sum> colours;
        double mean[4] = {};
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QRgb pixel = image.pixel(x, y);
                if (colours.size() <= kFew) {
                    Sum& sum = colours[pixel];
                    sum.count += 1.0;
                    sum.x += x;
                    sum.y += y;
                }
                for (const auto& [i, part] :
                     {std::pair{0, qAlpha(pixel)}, {1, qRed(pixel)}, {2, qGreen(pixel)}, {3, qBlue(pixel)}})
                    mean[i] += part / (static_cast<double>(image.width()) * image.height());
            }
        if (colours.size() > kFew)
            return QStringLiteral(" mean %1,%2,%3,%4")
                .arg(number(mean[0]), number(mean[1]), number(mean[2]), number(mean[3]));
        QString text;
        for (const auto& [colour, sum] : colours)
            text += QStringLiteral(" %1 n %2 about %3")
                        .arg(QColor::fromRgba(colour).name(QColor::HexArgb))
                        .arg(sum.count)
                        .arg(place(QPointF(sum.x, sum.y) / sum.count));
        return text;
    }

    /// Words and shapes come by turns; each kind is put together as long as it lasts.
    void add(Item item) {
        if (!m_run.empty() && m_run.back().text.isEmpty() != item.text.isEmpty())
            flush();
        m_run.push_back(std::move(item));
    }
    void flush() {
        std::vector<std::pair<QString, std::vector<const Item*>>> groups; // in the order in which they begin
        for (const Item& item : m_run) {
            const QString key = item.kind + item.look;
            auto at = std::find_if(groups.begin(), groups.end(),
                                   [&](const auto& group) { return group.first == key; });
            if (at == groups.end())
                at = groups.insert(groups.end(), {key, {}});
            at->second.push_back(&item);
        }
        for (const auto& [key, items] : groups) {
            if (items[0]->look != m_look) {
                m_look = items[0]->look;
                m_lines << m_look;
            }
            if (!items[0]->text.isEmpty()) {
                QString line = QLatin1Char(' ') + items[0]->kind;
                for (const Item* item : items) {
                    if (line.size() > 160) {
                        m_lines << line;
                        line = QLatin1Char(' ') + item->kind;
                    }
                    line += QLatin1Char(' ') + item->text;
                }
                m_lines << line;
            } else if (items.size() >= 4) {
                m_lines << QStringLiteral(" %1 %2s, ").arg(items.size()).arg(items[0]->kind) + told(items);
            } else {
                for (const Item* item : items)
                    m_lines << QStringLiteral(" %1 ").arg(item->kind) +
                                   (item->points.size() > 4 ? told({item}) : corners(*item));
            }
        }
        m_run.clear();
    }
    static QString corners(const Item& item) {
        QStringList places;
        for (const QPointF& p : item.points)
            places << place(p);
        return places.join(QLatin1Char(' '));
    }
    static QString told(const std::vector<const Item*>& items) {
        QRectF all;
        QPointF sum;
        double weight = 0.0, length = 0.0, corners = 0.0;
        QPointF low = items[0]->points[0], high = low;
        for (const Item* item : items)
            for (std::size_t i = 0; i < item->points.size(); ++i) {
                const QPointF p = item->points[i];
                low = {std::min(low.x(), p.x()), std::min(low.y(), p.y())};
                high = {std::max(high.x(), p.x()), std::max(high.y(), p.y())};
                corners += 1.0;
                weight += corners;
                sum += corners * p;
                if (i > 0)
                    length += std::hypot(p.x() - item->points[i - 1].x(), p.y() - item->points[i - 1].y());
            }
        return QStringLiteral("%1 corners in %2 about %3 long %4")
            .arg(corners)
            .arg(box({low, high}), place(sum / weight), number(length));
    }

    Mask m_mask;
    QTransform m_toDevice;
    QPen m_pen;
    QBrush m_brush;
    QRectF m_clip; ///< device units
    bool m_clipped = false;
    double m_opacity = 1.0;
    QPainter::CompositionMode m_mode = QPainter::CompositionMode_SourceOver;
    std::vector<Item> m_run;
    QString m_look; ///< of the last line
    QStringList m_lines;
};

/// A surface of so many pixels that takes down what is painted on it.
class OutlineDevice final : public QPaintDevice {
public:
    explicit OutlineDevice(QSize size, OutlineEngine::Mask mask = {})
        : m_size(size), m_engine(std::move(mask)) {}
    QPaintEngine* paintEngine() const override { return &m_engine; }
    QStringList take() { return m_engine.take(); }

    static QStringList of(QWidget& widget) {
        OutlineDevice device(widget.size());
        widget.render(&device);
        return device.take();
    }

protected:
    int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
        case PdmWidth:
            return m_size.width();
        case PdmHeight:
            return m_size.height();
        case PdmWidthMM:
            return qRound(m_size.width() * 25.4 / 96.0);
        case PdmHeightMM:
            return qRound(m_size.height() * 25.4 / 96.0);
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return 96;
        case PdmNumColors:
            return 1 << 24;
        case PdmDepth:
            return 32;
        case PdmDevicePixelRatio:
            return 1;
        default:
            return QPaintDevice::metric(metric);
        }
    }

private:
    QSize m_size;
    mutable OutlineEngine m_engine;
};

/// A printer of A4 pages, a pixel 1/96 inch, that takes down what is painted on them.
class OutlinePages final : public QPdfWriter {
public:
    explicit OutlinePages(OutlineEngine::Mask mask = {})
        : QPdfWriter(static_cast<QIODevice*>(nullptr)), m_engine(std::move(mask)) {
        setResolution(96);
        setPageSize(QPageSize(QPageSize::A4));
        setPageMargins(QMarginsF(0, 0, 0, 0));
        m_engine.say(QStringLiteral("-- page 1"));
    }
    bool newPage() override {
        m_engine.say(QStringLiteral("-- page %1").arg(++m_pages));
        return true;
    }
    int pages() const { return m_pages; }
    QStringList take() { return m_engine.take(); }

protected:
    QPaintEngine* paintEngine() const override { return &m_engine; }

private:
    mutable OutlineEngine m_engine;
    int m_pages = 1;
};

} // namespace chiron::tests
