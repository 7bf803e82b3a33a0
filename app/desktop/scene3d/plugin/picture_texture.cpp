// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/picture_texture.h"

#include <QSharedPointer>
#include <Qt3DRender/QAbstractTextureImage>
#include <Qt3DRender/QTextureImageData>
#include <Qt3DRender/QTextureImageDataGenerator>
#include <Qt3DRender/QTextureWrapMode>
#include <future>

namespace chiron::scene3d {

namespace {

struct Painting {
    std::string name;
    QSize size_px;
    std::shared_future<std::vector<std::uint8_t>> bytes;
};

class PictureGenerator final : public Qt3DRender::QTextureImageDataGenerator {
public:
    QT3D_FUNCTOR(PictureGenerator)

    explicit PictureGenerator(Painting painting) : m_painting(std::move(painting)) {}

    Qt3DRender::QTextureImageDataPtr operator()() override {
        const std::vector<std::uint8_t>& bytes = m_painting.bytes.get();
        auto data = Qt3DRender::QTextureImageDataPtr::create();
        data->setTarget(QOpenGLTexture::Target2D);
        data->setFormat(QOpenGLTexture::RGBA8_UNorm);
        data->setPixelFormat(QOpenGLTexture::RGBA);
        data->setPixelType(QOpenGLTexture::UInt8);
        data->setWidth(m_painting.size_px.width());
        data->setHeight(m_painting.size_px.height());
        data->setDepth(1);
        data->setFaces(1);
        data->setLayers(1);
        data->setMipLevels(1);
        data->setData(QByteArray(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())), 4,
                      false);
        return data;
    }
    bool operator==(const Qt3DRender::QTextureImageDataGenerator& other) const override {
        const auto* same = Qt3DCore::functor_cast<PictureGenerator>(&other);
        return same && same->m_painting.name == m_painting.name;
    }

private:
    Painting m_painting;
};

class PictureImage final : public Qt3DRender::QAbstractTextureImage {
public:
    PictureImage(Painting painting, Qt3DCore::QNode* parent)
        : QAbstractTextureImage(parent), m_painting(std::move(painting)) {}

protected:
    Qt3DRender::QTextureImageDataGeneratorPtr dataGenerator() const override {
        return QSharedPointer<PictureGenerator>::create(m_painting);
    }

private:
    Painting m_painting;
};

} // namespace

Qt3DRender::QAbstractTexture* makePictureTexture(const std::string& name, const QSize& size_px,
                                                 std::function<std::vector<std::uint8_t>()> paint,
                                                 Qt3DCore::QNode* parent) {
    auto* texture = new Qt3DRender::QTexture2D(parent);
    texture->setFormat(Qt3DRender::QAbstractTexture::RGBA8_UNorm);
    texture->setWidth(size_px.width());
    texture->setHeight(size_px.height());
    texture->setGenerateMipMaps(true);
    texture->setMinificationFilter(Qt3DRender::QAbstractTexture::LinearMipMapNearest);
    texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Linear);
    texture->setWrapMode(Qt3DRender::QTextureWrapMode(Qt3DRender::QTextureWrapMode::Repeat));
    texture->addTextureImage(
        new PictureImage({name, size_px, std::async(std::launch::async, std::move(paint)).share()}, texture));
    return texture;
}

} // namespace chiron::scene3d
