// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPageSize>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainterPath>
#include <QPdfWriter>
#include <QTextItem>
#include <QWidget>

#include <algorithm>
#include <utility>
#include <vector>

namespace chiron::tests {

/// One thing that was painted, in device units.
struct PaintedShape {
    enum class Kind { line, rect, ellipse, polygon, polyline, path, points, picture, words };
    Kind kind = Kind::rect;
    QRectF bounds;                ///< without the width of the pen; of words: their box
    std::vector<QPointF> corners; ///< of a rectangle or an ellipse: upper left, lower right
    QPen pen{Qt::NoPen};          ///< of words: their colour
    QBrush brush{Qt::NoBrush};    ///< none for what has no inside
    QPainterPath clip;            ///< empty: not clipped
    QString text;                 ///< of words
    QFont font;                   ///< of words
    QImage picture;               ///< of a picture

    bool filled() const { return brush.style() != Qt::NoBrush; }
    bool drawn() const { return pen.style() != Qt::NoPen; }
    /// All but the colours: whether two shapes differ in form.
    bool sameForm(const PaintedShape& other) const {
        return kind == other.kind && corners == other.corners && filled() == other.filled() &&
               brush.style() == other.brush.style() && drawn() == other.drawn() &&
               (!drawn() || (pen.style() == other.pen.style() && pen.widthF() == other.pen.widthF())) &&
               text == other.text && clip == other.clip;
    }
    bool operator==(const PaintedShape& other) const {
        return sameForm(other) && (!filled() || brush == other.brush) &&
               (!drawn() || pen.color() == other.pen.color()) && font == other.font &&
               picture == other.picture;
    }
};

/// Notes what is painted; the surfaces below use it.
class ShapesEngine final : public QPaintEngine {
public:
    ShapesEngine() : QPaintEngine(AllFeatures) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }

    void updateState(const QPaintEngineState& now) override {
        const auto dirty = now.state();
        if (dirty & DirtyTransform)
            m_toDevice = now.transform();
        if (dirty & DirtyPen)
            m_pen = now.pen();
        if (dirty & DirtyBrush)
            m_brush = now.brush();
        if (dirty & DirtyClipEnabled)
            m_clipped = now.isClipEnabled();
        if (dirty & DirtyClipPath)
            clip(now.clipOperation(), now.clipPath());
        if (dirty & DirtyClipRegion) {
            QPainterPath region;
            region.addRegion(now.clipRegion());
            clip(now.clipOperation(), region);
        }
    }
    void drawLines(const QLineF* lines, int count) override {
        for (int i = 0; i < count; ++i)
            add(Kind::line, {lines[i].p1(), lines[i].p2()}, false);
    }
    void drawLines(const QLine* lines, int count) override {
        for (int i = 0; i < count; ++i)
            add(Kind::line, {lines[i].p1(), lines[i].p2()}, false);
    }
    void drawRects(const QRectF* rects, int count) override {
        for (int i = 0; i < count; ++i)
            add(Kind::rect, {rects[i].topLeft(), rects[i].bottomRight()}, true);
    }
    void drawRects(const QRect* rects, int count) override {
        for (int i = 0; i < count; ++i)
            add(Kind::rect, {QRectF(rects[i]).topLeft(), QRectF(rects[i]).bottomRight()}, true);
    }
    void drawEllipse(const QRectF& rect) override {
        add(Kind::ellipse, {rect.topLeft(), rect.bottomRight()}, true);
    }
    void drawEllipse(const QRect& rect) override { drawEllipse(QRectF(rect)); }
    void drawPoints(const QPointF* points, int count) override {
        add(Kind::points, {points, points + count}, false);
    }
    void drawPoints(const QPoint* points, int count) override {
        add(Kind::points, {points, points + count}, false);
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        add(mode == PolylineMode ? Kind::polyline : Kind::polygon, {points, points + count},
            mode != PolylineMode);
    }
    void drawPolygon(const QPoint* points, int count, PolygonDrawMode mode) override {
        add(mode == PolylineMode ? Kind::polyline : Kind::polygon, {points, points + count},
            mode != PolylineMode);
    }
    void drawPath(const QPainterPath& path) override {
        std::vector<QPointF> corners;
        for (int i = 0; i < path.elementCount(); ++i)
            corners.push_back(path.elementAt(i));
        add(Kind::path, std::move(corners), true);
    }
    void drawPixmap(const QRectF& to, const QPixmap& pixmap, const QRectF&) override {
        drawImage(to, pixmap.toImage(), {}, {});
    }
    void drawTiledPixmap(const QRectF& to, const QPixmap& pixmap, const QPointF&) override {
        drawImage(to, pixmap.toImage(), {}, {});
    }
    void drawImage(const QRectF& to, const QImage& image, const QRectF&, Qt::ImageConversionFlags) override {
        PaintedShape& shape = add(Kind::picture, {to.topLeft(), to.bottomRight()}, false);
        shape.pen = QPen(Qt::NoPen);
        shape.picture = image;
    }
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        PaintedShape& shape =
            add(Kind::words, {at - QPointF(0.0, item.ascent()), at + QPointF(item.width(), item.descent())},
                false);
        shape.text = item.text();
        shape.font = item.font();
    }

    std::vector<PaintedShape> shapes;

private:
    using Kind = PaintedShape::Kind;
    void clip(Qt::ClipOperation operation, const QPainterPath& to) {
        const QPainterPath device = m_toDevice.map(to);
        m_clip = operation == Qt::NoClip                               ? QPainterPath()
                 : operation == Qt::IntersectClip && !m_clip.isEmpty() ? m_clip.intersected(device)
                                                                       : device;
        m_clipped = operation != Qt::NoClip;
    }
    PaintedShape& add(Kind kind, std::vector<QPointF> corners, bool inside) {
        PaintedShape shape;
        shape.kind = kind;
        for (QPointF& corner : corners)
            corner = m_toDevice.map(corner);
        if (!corners.empty()) {
            QPointF low = corners.front(), high = low;
            for (const QPointF& corner : corners) {
                low = {std::min(low.x(), corner.x()), std::min(low.y(), corner.y())};
                high = {std::max(high.x(), corner.x()), std::max(high.y(), corner.y())};
            }
            shape.bounds = {low, high};
        }
        shape.corners = std::move(corners);
        shape.pen = m_pen;
        if (inside)
            shape.brush = m_brush;
        if (m_clipped)
            shape.clip = m_clip;
        shapes.push_back(std::move(shape));
        return shapes.back();
    }

    QTransform m_toDevice;
    QPen m_pen;
    QBrush m_brush;
    QPainterPath m_clip;
    bool m_clipped = false;
};

/// A surface that notes what is painted on it, for tests that ask a widget or a painter what it paints.
/// paint_outline.h notes the same as lines of text to be kept.
class PaintedShapes final : public QPaintDevice {
public:
    explicit PaintedShapes(QSize size) : m_size(size) {}
    QPaintEngine* paintEngine() const override { return &m_engine; }
    const std::vector<PaintedShape>& shapes() const { return m_engine.shapes; }

    static std::vector<PaintedShape> of(QWidget& widget) {
        PaintedShapes device(widget.size());
        widget.render(&device);
        return device.shapes();
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
    mutable ShapesEngine m_engine;
};

/// A printer of A4 pages, a pixel 1/96 inch, that notes what is painted on all of them.
class PaintedPages final : public QPdfWriter {
public:
    PaintedPages() : QPdfWriter(static_cast<QIODevice*>(nullptr)) {
        setResolution(96);
        setPageSize(QPageSize(QPageSize::A4));
        setPageMargins(QMarginsF(0, 0, 0, 0));
    }
    bool newPage() override { return true; }
    const std::vector<PaintedShape>& shapes() const { return m_engine.shapes; }

protected:
    QPaintEngine* paintEngine() const override { return &m_engine; }

private:
    mutable ShapesEngine m_engine;
};

/// How much of the picture the shapes take that one painting has and the other lacks, whatever their colours:
/// the sum of their boxes.
inline double differingForms_px(const std::vector<PaintedShape>& a, const std::vector<PaintedShape>& b) {
    double sum_px = 0.0;
    for (const auto& [shapes, others] : {std::pair{&a, &b}, std::pair{&b, &a}})
        for (const PaintedShape& shape : *shapes)
            if (std::none_of(others->begin(), others->end(),
                             [&](const PaintedShape& other) { return other.sameForm(shape); }))
                sum_px += std::max(1.0, shape.bounds.width()) * std::max(1.0, shape.bounds.height());
    return sum_px;
}

/// The texts among painted shapes, in the order of painting.
inline QStringList wordsIn(const std::vector<PaintedShape>& shapes) {
    QStringList words;
    for (const PaintedShape& shape : shapes)
        if (shape.kind == PaintedShape::Kind::words)
            words << shape.text;
    return words;
}

} // namespace chiron::tests
