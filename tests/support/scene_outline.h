// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/drawing_outline.h"

#include <QCryptographicHash>
#include <QMap>
#include <QMetaProperty>
#include <QPainter>
#include <QStringList>
#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QEntity>
#include <Qt3DCore/QGeometry>
#include <Qt3DCore/QTransform>
#include <Qt3DRender/QAbstractTextureImage>
#include <Qt3DRender/QBlendEquationArguments>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QCameraLens>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QFrameGraphNode>
#include <Qt3DRender/QGeometryRenderer>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QLayer>
#include <Qt3DRender/QLayerFilter>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QPaintedTextureImage>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QRenderPassFilter>
#include <Qt3DRender/QRenderSettings>
#include <Qt3DRender/QRenderTarget>
#include <Qt3DRender/QRenderTargetOutput>
#include <Qt3DRender/QRenderTargetSelector>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>
#include <Qt3DRender/QTexture>
#include <Qt3DRender/QTextureImageData>
#include <Qt3DRender/QTextureImageDataGenerator>
#include <Qt3DRender/QTextureWrapMode>
#include <Qt3DRender/QViewport>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace chiron::tests {

/// What a scene of three dimensions is made of, as lines of text, read off Qt3D's nodes without a display: of
/// each entity that is shown its place, its shape (how many points of what, and where they lie on average),
/// its look and the values that its shaders are given; the cameras; in which order what is drawn. What is
/// drawn in one scene again and again is said once: of a second state of() tells what became another.
class SceneOutline {
public:
    /// What differs from what it told before; all of it the first time.
    QStringList of(const Qt3DCore::QEntity& root) {
        QMap<QString, QStringList> now;
        QStringList order;
        add(root, QStringLiteral("0"), now, order);
        QStringList lines = std::exchange(m_new, {});
        for (const QString& path : order)
            if (const QStringList before = m_before.value(path); before != now[path]) {
                lines << path + QLatin1Char(' ') + now[path].front();
                for (const QString& line : now[path].mid(1))
                    if (!before.contains(line))
                        lines << QStringLiteral("  ") + line;
                for (const QString& line : before.mid(1)) // of what is shown still
                    if (now[path].size() > 1 &&
                        std::none_of(now[path].begin(), now[path].end(),
                                     [&](const QString& other) { return kind(other) == kind(line); }))
                        lines << QStringLiteral("  no more ") + kind(line);
            }
        for (auto it = m_before.begin(); it != m_before.end(); ++it)
            if (!now.contains(it.key()))
                lines << it.key() + QStringLiteral(" gone");
        m_before = now;
        return lines;
    }

private:
    using Lines = QMap<QString, QStringList>;

    static QString kind(const QString& line) {
        return line.section(QLatin1Char('='), 0, 0).section(QLatin1Char(' '), 0, 0);
    }

    /// What is said once, under a number: shapes, looks, pictures. `kind`: one letter.
    QString named(const QString& kind, const QString& text) {
        const auto known = m_names.find(kind + text);
        if (known != m_names.end())
            return *known;
        const QString name = kind + QString::number(++m_counts[kind]);
        m_names[kind + text] = name;
        m_new << name + QStringLiteral(": ") + text;
        return name;
    }
    QString numbered(const char* kind, const QObject* object) {
        if (!object)
            return QStringLiteral("none");
        const auto at = m_numbers.find(object);
        if (at != m_numbers.end())
            return *at;
        const QString name = QLatin1String(kind) + QString::number(++m_counts[QLatin1String(kind)]);
        return m_numbers[object] = name;
    }

    static QString className(const QObject& object) {
        return QString::fromLatin1(object.metaObject()->className()).section(QStringLiteral("::"), -1);
    }
    static QString off(const Qt3DCore::QNode& node) {
        return node.isEnabled() ? QString() : QStringLiteral(" off");
    }

    static std::vector<double> of(const QVector3D& v) { return {v.x(), v.y(), v.z()}; }
    static QString matrix(const QMatrix4x4& m) {
        QStringList rows;
        for (int row = 0; row < 4; ++row)
            rows << outlined({m(row, 0), m(row, 1), m(row, 2)}) + QStringLiteral(" ") + outlined({m(row, 3)});
        return rows.join(QStringLiteral(" | "));
    }
    /// Columns that are something for themselves: a place each, with a number beside it.
    static QString columns(const QMatrix4x4& m) {
        QStringList said;
        for (int i = 0; i < 4; ++i)
            said << outlinedEach({m(0, i), m(1, i), m(2, i), m(3, i)});
        return said.join(QStringLiteral(" | "));
    }

    QString value(const QVariant& value) {
        if (value.canConvert<Qt3DRender::QAbstractTexture*>())
            if (auto* texture = value.value<Qt3DRender::QAbstractTexture*>())
                return picture(*texture);
        switch (value.typeId()) {
        case QMetaType::QVector2D: {
            const auto v = value.value<QVector2D>();
            return outlinedEach({v.x(), v.y()});
        }
        case QMetaType::QVector3D:
            return outlinedEach(of(value.value<QVector3D>()));
        case QMetaType::QVector4D: {
            const auto v = value.value<QVector4D>();
            return outlinedEach({v.x(), v.y(), v.z(), v.w()});
        }
        case QMetaType::QMatrix4x4:
            return columns(value.value<QMatrix4x4>());
        case QMetaType::Float:
        case QMetaType::Double:
        case QMetaType::Int:
        case QMetaType::Bool:
            return outlined({value.toDouble()});
        default:
            return QString::fromLatin1(value.typeName()) + QLatin1Char(' ') + value.toString();
        }
    }

    QString parameters(const QList<Qt3DRender::QParameter*>& all) {
        QStringList said;
        for (const Qt3DRender::QParameter* parameter : all)
            said << parameter->name() + QLatin1Char('=') + value(parameter->value());
        return said.join(QStringLiteral("; "));
    }

    // ---- pictures ----
    QString picture(Qt3DRender::QAbstractTexture& texture) {
        const auto* wrap = texture.wrapMode();
        QString text = QStringLiteral("%1 %2x%3 format %4 filters %5/%6 wrap %7/%8%9")
                           .arg(className(texture))
                           .arg(texture.width())
                           .arg(texture.height())
                           .arg(texture.format())
                           .arg(texture.minificationFilter())
                           .arg(texture.magnificationFilter())
                           .arg(wrap->x())
                           .arg(wrap->y())
                           .arg(texture.generateMipMaps() ? QStringLiteral(" mip maps") : QString());
        for (Qt3DRender::QAbstractTextureImage* image : texture.textureImages())
            text += QStringLiteral(" of ") +
                    (qobject_cast<Qt3DRender::QPaintedTextureImage*>(image)
                         ? painted(*qobject_cast<Qt3DRender::QPaintedTextureImage*>(image))
                         : made(*image));
        return texture.textureImages().isEmpty() ? numbered("target", &texture) + QLatin1Char(' ') + text
                                                 : named(QStringLiteral("P"), text);
    }
    static QString painted(Qt3DRender::QPaintedTextureImage& image) {
        struct Open : Qt3DRender::QPaintedTextureImage {
            using QPaintedTextureImage::paint;
        };
        DrawingOutline drawing(image.size());
        QPainter painter(&drawing);
        (image.*(&Open::paint))(&painter);
        painter.end();
        return QStringLiteral("drawing %1x%2: ").arg(image.width()).arg(image.height()) + drawing.said();
    }
    /// What is computed, once for all states: it takes its time.
    QString made(Qt3DRender::QAbstractTextureImage& image) {
        if (const auto known = m_made.find(&image); known != m_made.end())
            return *known;
        struct Open : Qt3DRender::QAbstractTextureImage {
            using QAbstractTextureImage::dataGenerator;
        };
        const auto generator = (image.*(&Open::dataGenerator))();
        const auto data = generator ? (*generator)() : Qt3DRender::QTextureImageDataPtr();
        if (!data)
            return m_made[&image] = className(image);
        const QByteArray bytes = data->data();
        const int width = std::max(1, data->width());
        const double count = std::max(1.0, double(bytes.size()) / 4.0);
        std::vector<double> sums(
            16, 0.0); // of each channel the mean, and what lies left and right, above and below, and across
        for (qsizetype i = 0; i < bytes.size(); ++i) {
            const double value = static_cast<std::uint8_t>(bytes[i]) / count;
            const double across = std::sin(2.0 * M_PI * double(i / 4 % width) / width),
                         down = std::sin(2.0 * M_PI * double(i / 4 / width) * width / count);
            double* of = &sums[std::size_t(4 * (i % 4))];
            of[0] += value;
            of[1] += value * across;
            of[2] += value * down;
            of[3] += value * across * (1.0 + down);
        }
        return m_made[&image] =
                   QStringLiteral("computed %1x%2 target %3 format %4 pixels %5/%6 layers %7 faces %8 %9")
                       .arg(data->width())
                       .arg(data->height())
                       .arg(data->target())
                       .arg(data->format())
                       .arg(data->pixelFormat())
                       .arg(data->pixelType())
                       .arg(data->layers())
                       .arg(data->faces())
                       .arg(outlined(sums, 5));
    }

    // ---- looks ----
    QString look(const Qt3DRender::QEffect* effect) {
        if (!effect)
            return QStringLiteral("none");
        QStringList said;
        for (const Qt3DRender::QTechnique* technique : effect->techniques()) {
            const auto* api = const_cast<Qt3DRender::QTechnique*>(technique)->graphicsApiFilter();
            said << QStringLiteral("api %1/%2/%3.%4")
                        .arg(api->api())
                        .arg(api->profile())
                        .arg(api->majorVersion())
                        .arg(api->minorVersion());
            for (const Qt3DRender::QRenderPass* pass : technique->renderPasses())
                said << this->pass(*pass);
        }
        return named(QStringLiteral("L"), said.join(QStringLiteral("; ")));
    }
    /// A shader by the number of its lines and a digest: an edit of it is a change that is meant, too.
    static QString shader(const QByteArray& code) {
        return QString::number(code.count('\n')) + QLatin1Char('-') +
               QString::fromLatin1(QCryptographicHash::hash(code, QCryptographicHash::Md5).toHex().left(8));
    }
    static QString pass(const Qt3DRender::QRenderPass& pass) {
        QStringList said;
        for (const Qt3DRender::QFilterKey* key : pass.filterKeys())
            said << key->name() + QLatin1Char('=') + key->value().toString();
        if (const auto* program = pass.shaderProgram())
            said << QStringLiteral("vertex %1 fragment %2")
                        .arg(shader(program->vertexShaderCode()), shader(program->fragmentShaderCode()));
        for (const Qt3DRender::QRenderState* state : pass.renderStates()) {
            QString text = className(*state);
            const QMetaObject& meta = *state->metaObject();
            for (int i = Qt3DRender::QRenderState::staticMetaObject.propertyCount(); i < meta.propertyCount();
                 ++i)
                text += QLatin1Char(' ') + meta.property(i).read(state).toString();
            said << text;
        }
        return said.join(QLatin1Char(' '));
    }

    // ---- shapes ----
    /// Of each component: mean, least, most, and a sum in which every place has another weight.
    static QString floats(const Qt3DCore::QAttribute& attribute) {
        const QByteArray bytes = attribute.buffer()->data();
        const std::size_t size = attribute.vertexSize(), count = attribute.count();
        const std::size_t stride = attribute.byteStride() ? attribute.byteStride() : size * sizeof(float);
        QStringList said;
        for (std::size_t k = 0; k < size; ++k) {
            double mean = 0.0, weighted = 0.0, least = 1e300, most = -1e300;
            for (std::size_t i = 0; i < count; ++i) {
                const std::size_t at = attribute.byteOffset() + i * stride + k * sizeof(float);
                if (at + sizeof(float) > std::size_t(bytes.size()))
                    return QStringLiteral("beyond its buffer");
                float x = 0.0F;
                std::memcpy(&x, bytes.constData() + at, sizeof x);
                mean += x;
                weighted += x * double(i * 2654435761U % 1009) / 1009.0;
                least = std::min(least, double(x));
                most = std::max(most, double(x));
            }
            said << (count == 0 ? QStringLiteral("none")
                                : outlined({mean / double(count), least, most, weighted / double(count)}, 5));
        }
        return said.join(QStringLiteral(", "));
    }
    static QString indices(const Qt3DCore::QAttribute& attribute) {
        const QByteArray bytes = attribute.buffer()->data();
        std::uint64_t sum = 0, weighted = 0;
        const std::size_t count =
            std::min<std::size_t>(attribute.count(), std::size_t(bytes.size()) / sizeof(std::uint32_t));
        for (std::size_t i = 0; i < count; ++i) {
            std::uint32_t x = 0;
            std::memcpy(&x, bytes.constData() + i * sizeof x, sizeof x);
            sum += x;
            weighted = (weighted * 31 + x) % 1'000'003;
        }
        return QStringLiteral("sum %1 chain %2").arg(sum).arg(weighted);
    }
    QString shape(const Qt3DRender::QGeometryRenderer& renderer) {
        QString text = QStringLiteral("primitive %1, vertices %2 from %3, indices from %4/%5, instances %6")
                           .arg(renderer.primitiveType())
                           .arg(renderer.vertexCount())
                           .arg(renderer.firstVertex())
                           .arg(renderer.indexOffset())
                           .arg(renderer.indexBufferByteOffset())
                           .arg(renderer.instanceCount());
        if (const Qt3DCore::QGeometry* geometry = renderer.geometry())
            for (const Qt3DCore::QAttribute* attribute : geometry->attributes()) {
                const bool index = attribute->attributeType() == Qt3DCore::QAttribute::IndexAttribute;
                text += QStringLiteral("; %1 %2x%3 type %4 ")
                            .arg(index ? QStringLiteral("index") : attribute->name())
                            .arg(attribute->count())
                            .arg(attribute->vertexSize())
                            .arg(attribute->vertexBaseType());
                text += index                                                        ? indices(*attribute)
                        : attribute->vertexBaseType() == Qt3DCore::QAttribute::Float ? floats(*attribute)
                                                                                     : QString();
                if (geometry->boundingVolumePositionAttribute() == attribute)
                    text += QStringLiteral(" bounds");
            }
        return named(QStringLiteral("S"), text);
    }

    // ---- order of drawing ----
    void add(const Qt3DRender::QFrameGraphNode& node, const QString& path, Lines& now, QStringList& order) {
        QStringList said{className(node) + off(node)};
        if (const auto* viewport = qobject_cast<const Qt3DRender::QViewport*>(&node)) {
            const QRectF r = viewport->normalizedRect();
            said << QStringLiteral("rect ") + outlined({r.x(), r.y(), r.width(), r.height()}) +
                        QStringLiteral(" gamma ") + outlined({viewport->gamma()});
        } else if (const auto* clear = qobject_cast<const Qt3DRender::QClearBuffers*>(&node)) {
            said << QStringLiteral("buffers %1 %2 %3")
                        .arg(clear->buffers())
                        .arg(clear->clearColor().name())
                        .arg(clear->clearDepthValue());
        } else if (const auto* filter = qobject_cast<const Qt3DRender::QLayerFilter*>(&node)) {
            QString text = QStringLiteral("mode %1:").arg(filter->filterMode());
            for (const Qt3DRender::QLayer* layer : filter->layers())
                text += QLatin1Char(' ') + numbered("layer", layer);
            said << text;
        } else if (const auto* camera = qobject_cast<const Qt3DRender::QCameraSelector*>(&node)) {
            said << numbered("camera", camera->camera());
        } else if (const auto* passes = qobject_cast<const Qt3DRender::QRenderPassFilter*>(&node)) {
            for (const Qt3DRender::QFilterKey* key : passes->matchAny())
                said << key->name() + QLatin1Char('=') + key->value().toString();
            said << parameters(passes->parameters());
        } else if (const auto* selector = qobject_cast<const Qt3DRender::QRenderTargetSelector*>(&node);
                   selector && selector->target()) {
            for (const Qt3DRender::QRenderTargetOutput* output : selector->target()->outputs())
                said << QStringLiteral("output %1 ").arg(output->attachmentPoint()) +
                            picture(*output->texture());
        }
        now[path] = said;
        order << path;
        int number = 0;
        if (node.isEnabled())
            for (const QObject* child : node.children())
                if (const auto* below = qobject_cast<const Qt3DRender::QFrameGraphNode*>(child))
                    add(*below, path + QLatin1Char('.') + QString::number(++number), now, order);
    }

    // ---- entities ----
    void component(const Qt3DCore::QComponent& part, QStringList& said, const QString& path, Lines& now,
                   QStringList& order) {
        if (const auto* transform = qobject_cast<const Qt3DCore::QTransform*>(&part)) {
            const QMatrix4x4 m = transform->matrix();
            if (!m.isIdentity() || !part.isEnabled())
                said << QStringLiteral("at ") + outlinedEach({m(0, 3), m(1, 3), m(2, 3)}) + off(part);
            QMatrix4x4 rest = m;
            rest.setColumn(3, QVector4D(0, 0, 0, 1));
            if (!rest.isIdentity())
                said << QStringLiteral("axes ") + outlined({m(0, 0), m(1, 0), m(2, 0)}) +
                            QStringLiteral(" | ") + outlined({m(0, 1), m(1, 1), m(2, 1)}) +
                            QStringLiteral(" | ") + outlined({m(0, 2), m(1, 2), m(2, 2)});
        } else if (const auto* renderer = qobject_cast<const Qt3DRender::QGeometryRenderer*>(&part)) {
            said << QStringLiteral("shape ") + shape(*renderer) + off(part);
        } else if (const auto* material = qobject_cast<const Qt3DRender::QMaterial*>(&part)) {
            said << QStringLiteral("look ") + look(material->effect()) + off(part);
            for (const Qt3DRender::QParameter* parameter : material->parameters())
                said << parameter->name() + QLatin1Char('=') + value(parameter->value());
        } else if (const auto* layer = qobject_cast<const Qt3DRender::QLayer*>(&part)) {
            said << numbered("layer", layer) +
                        (layer->recursive() ? QStringLiteral(" and below") : QString());
        } else if (const auto* lens = qobject_cast<const Qt3DRender::QCameraLens*>(&part)) {
            said << QStringLiteral("lens ") + matrix(lens->projectionMatrix());
        } else if (const auto* settings = qobject_cast<const Qt3DRender::QRenderSettings*>(&part)) {
            said << QStringLiteral("render policy %1").arg(settings->renderPolicy());
            if (const auto* graph = settings->activeFrameGraph())
                add(*graph, path + QStringLiteral("/graph"), now, order);
        } else {
            said << className(part) + off(part);
        }
    }

    void add(const Qt3DCore::QEntity& entity, const QString& path, Lines& now, QStringList& order) {
        QStringList said{
            className(entity).remove(QStringLiteral("QEntity")) +
            (entity.objectName().isEmpty() ? QString() : QStringLiteral("#") + entity.objectName()) +
            off(entity)};
        order << path;
        if (entity.isEnabled()) { // what is not shown has no look
            if (const auto* camera = qobject_cast<const Qt3DRender::QCamera*>(&entity))
                said << numbered("camera", camera) + QStringLiteral(" from ") +
                            outlined(of(camera->position())) + QStringLiteral(" to ") +
                            outlined(of(camera->viewCenter())) + QStringLiteral(" up ") +
                            outlined(of(camera->upVector()));
            for (const Qt3DCore::QComponent* part : entity.components())
                component(*part, said, path, now, order);
        }
        now[path] = said;
        int number = 0;
        for (const QObject* child : entity.children()) {
            const auto* below = qobject_cast<const Qt3DCore::QEntity*>(child);
            if (!below)
                continue;
            ++number;
            if (entity.isEnabled())
                add(*below, path + QLatin1Char('.') + QString::number(number), now, order);
        }
    }

    QMap<QString, QStringList> m_before;
    QMap<QString, QString> m_names;
    QMap<QString, int> m_counts;
    QMap<const QObject*, QString> m_numbers;
    QMap<const QObject*, QString> m_made;
    QStringList m_new;
};

} // namespace chiron::tests
