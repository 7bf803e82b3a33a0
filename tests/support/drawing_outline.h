// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCryptographicHash>
#include <QImage>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <vector>

namespace chiron::tests {

/// Numbers as they are kept: to `digits` of the largest of them, because sums of many points round
/// differently on different processors.
inline QString outlined(const std::vector<double>& values, int digits = 5, double scale = 0.0) {
    for (const double x : values)
        scale = std::max(scale, std::abs(x));
    if (!std::isfinite(scale) || scale < 1e-9)
        scale = 1e-9;
    const double unit = std::pow(10.0, std::floor(std::log10(scale)) - digits + 1);
    QStringList said;
    for (const double x : values) // 1e-6: what lies just between two numbers is always rounded alike
        said << (std::abs(x) < 1e-9
                     ? QStringLiteral("0")
                     : QString::number(std::floor(x / unit + 0.5 + 1e-6) * unit + 0.0, 'g', digits));
    return said.join(QLatin1Char(' '));
}

/// The same of values that are no sums and each mean something else: each to five digits of its own.
inline QString outlinedEach(const std::vector<double>& values) {
    double scale = 1e-3;
    for (const double x : values)
        scale = std::max(scale, std::abs(x));
    QStringList said;
    for (const double x : values)
        said << outlined({std::abs(x) < 1e-6 * scale ? 0.0 : x});
    return said.join(QLatin1Char(' '));
}

/// Takes down what a painter draws: shapes with their pens and brushes, words with their letters' size.
class DrawingOutline final : public QPaintDevice {
public:
    explicit DrawingOutline(const QSize& size) : m_size(size), m_engine(m_lines) {}
    QPaintEngine* paintEngine() const override { return &m_engine; }
    /// What was drawn, in its order; of what goes on and on (a signal's columns) the beginning, and a digest
    /// of the rest.
    QString said() const {
        constexpr qsizetype kMost = 24;
        QString text = m_lines.mid(0, kMost).join(QStringLiteral("; "));
        if (m_lines.size() > kMost)
            text += QStringLiteral("; and %1 more, %2")
                        .arg(m_lines.size() - kMost)
                        .arg(QLatin1String(
                            QCryptographicHash::hash(m_lines.mid(kMost).join(QLatin1Char(';')).toUtf8(),
                                                     QCryptographicHash::Md5)
                                .toHex()
                                .left(8)));
        return text;
    }

protected:
    int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
        case PdmWidth:
            return m_size.width();
        case PdmHeight:
            return m_size.height();
        case PdmDepth:
            return 32;
        case PdmWidthMM:
            return m_size.width() * 254 / 960;
        case PdmHeightMM:
            return m_size.height() * 254 / 960;
        case PdmNumColors:
            return 1 << 24;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return static_cast<int>(devicePixelRatioFScale());
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return 96;
        default:
            return QPaintDevice::metric(metric);
        }
    }

private:
    class Engine final : public QPaintEngine {
    public:
        explicit Engine(QStringList& lines) : QPaintEngine(AllFeatures), m_lines(lines) {}
        bool begin(QPaintDevice*) override { return true; }
        bool end() override { return true; }
        Type type() const override { return User; }
        void updateState(const QPaintEngineState&) override {}
        void drawPath(const QPainterPath& path) override {
            std::vector<double> points;
            for (int i = 0; i < path.elementCount(); ++i)
                add(points, path.elementAt(i));
            shape(QStringLiteral("path %1").arg(
                      path.fillRule() == Qt::WindingFill ? QStringLiteral("winding ") : QString()),
                  points);
        }
        void drawPolygon(const QPointF* corners, int count, PolygonDrawMode mode) override {
            std::vector<double> points;
            for (int i = 0; i < count; ++i)
                add(points, corners[i]);
            shape(QStringLiteral("polygon %1 ").arg(static_cast<int>(mode)), points);
        }
        void drawTextItem(const QPointF& at, const QTextItem& item) override {
            const QFont font = item.font();
            const QPointF place = painter()->transform().map(at); // to 4: how wide a letter is is the font's
            m_lines << QStringLiteral("words \"%1\" %2/%3 at %4,%5 %6")
                           .arg(item.text())
                           .arg(font.pixelSize())
                           .arg(font.weight())
                           .arg(4 * qRound(place.x() / 4))
                           .arg(4 * qRound(place.y() / 4))
                           .arg(painter()->pen().color().name(QColor::HexArgb));
        }
        void drawImage(const QRectF& at, const QImage& image, const QRectF&,
                       Qt::ImageConversionFlags) override {
            picture(at, image);
        }
        void drawPixmap(const QRectF& at, const QPixmap& pixmap, const QRectF&) override {
            picture(at, pixmap.toImage());
        }

    private:
        void add(std::vector<double>& points, const QPointF& at) const {
            const QPointF place = painter()->transform().map(at);
            points.push_back(place.x());
            points.push_back(place.y());
        }
        void shape(QString text, const std::vector<double>& points) {
            double weighted = 0.0;
            for (std::size_t i = 0; i < points.size(); ++i)
                weighted += points[i] * std::cos(double(i));
            if (points.size() > 12) { // a round one: where it begins and ends, and a sum of it all
                const auto [x, y] = std::pair{points[0], points[1]};
                text += QStringLiteral("%1 points %2 sum %3")
                            .arg(points.size() / 2)
                            .arg(outlined({x, y, points[points.size() - 2], points.back()}),
                                 outlined({weighted}));
            } else {
                text += outlined(points);
            }
            const QPen pen = painter()->pen();
            if (pen.style() != Qt::NoPen)
                text += QStringLiteral(" pen %1 %2/%3/%4")
                            .arg(pen.color().name(QColor::HexArgb))
                            .arg(pen.widthF())
                            .arg(pen.style())
                            .arg(pen.capStyle());
            if (painter()->brush().style() != Qt::NoBrush)
                text += QStringLiteral(" brush %1/%2")
                            .arg(painter()->brush().color().name(QColor::HexArgb))
                            .arg(painter()->brush().style());
            m_lines << text;
        }
        void picture(const QRectF& at, const QImage& image) {
            const QImage seen = image.convertToFormat(QImage::Format_ARGB32);
            std::vector<double> sums(8, 0.0);
            for (int y = 0; y < seen.height(); ++y)
                for (int x = 0; x < seen.width(); ++x) {
                    const QRgb dot = seen.pixel(x, y);
                    const double weight = std::cos(0.37 * x + 0.83 * y) / seen.width() / seen.height();
                    int i = 0;
                    for (const int channel : {qRed(dot), qGreen(dot), qBlue(dot), qAlpha(dot)}) {
                        sums[std::size_t(i++)] += double(channel) / seen.width() / seen.height();
                        sums[std::size_t(i++)] += weight * channel;
                    }
                }
            m_lines << QStringLiteral("picture %1x%2 at %3: %4")
                           .arg(seen.width())
                           .arg(seen.height())
                           .arg(outlined({at.x(), at.y(), at.width(), at.height()}), outlined(sums, 4));
        }
        QStringList& m_lines;
    };

    QSize m_size;
    QStringList m_lines;
    mutable Engine m_engine;
};

} // namespace chiron::tests
