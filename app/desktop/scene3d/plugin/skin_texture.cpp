// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/skin_texture.h"

#include "desktop/scene3d/parts/skin_picture.h"

#include <Qt3DRender/QAbstractTextureImage>
#include <Qt3DRender/QTextureImageData>
#include <Qt3DRender/QTextureImageDataGenerator>
#include <Qt3DRender/QTextureWrapMode>
#include <future>

namespace chiron::scene3d {

namespace {

constexpr int kSide_px = 512;

using Picture = std::shared_future<std::vector<std::uint8_t>>;

class SkinGenerator final : public Qt3DRender::QTextureImageDataGenerator {
public:
    QT3D_FUNCTOR(SkinGenerator)

    explicit SkinGenerator(Picture picture) : m_picture(std::move(picture)) {}

    Qt3DRender::QTextureImageDataPtr operator()() override {
        const std::vector<std::uint8_t>& picture = m_picture.get();
        auto data = Qt3DRender::QTextureImageDataPtr::create();
        data->setTarget(QOpenGLTexture::Target2D);
        data->setFormat(QOpenGLTexture::RGBA8_UNorm);
        data->setPixelFormat(QOpenGLTexture::RGBA);
        data->setPixelType(QOpenGLTexture::UInt8);
        data->setWidth(kSide_px);
        data->setHeight(kSide_px);
        data->setDepth(1);
        data->setFaces(1);
        data->setLayers(1);
        data->setMipLevels(1);
        data->setData(QByteArray(reinterpret_cast<const char*>(picture.data()), qsizetype(picture.size())), 4,
                      false);
        return data;
    }
    bool operator==(const Qt3DRender::QTextureImageDataGenerator& other) const override {
        return Qt3DCore::functor_cast<SkinGenerator>(&other) != nullptr;
    }

private:
    Picture m_picture;
};

class SkinImage final : public Qt3DRender::QAbstractTextureImage {
public:
    explicit SkinImage(Qt3DCore::QNode* parent)
        : QAbstractTextureImage(parent), m_picture(std::async(skinPicture, kSide_px)) {}

protected:
    Qt3DRender::QTextureImageDataGeneratorPtr dataGenerator() const override {
        return QSharedPointer<SkinGenerator>::create(m_picture);
    }

private:
    Picture m_picture; ///< painted while the context is made
};

} // namespace

Qt3DRender::QAbstractTexture* makeSkinTexture(Qt3DCore::QNode* parent) {
    auto* texture = new Qt3DRender::QTexture2D(parent);
    texture->setFormat(Qt3DRender::QAbstractTexture::RGBA8_UNorm);
    texture->setWidth(kSide_px);
    texture->setHeight(kSide_px);
    texture->setGenerateMipMaps(true);
    texture->setMinificationFilter(Qt3DRender::QAbstractTexture::LinearMipMapNearest);
    texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Linear);
    texture->setWrapMode(Qt3DRender::QTextureWrapMode(Qt3DRender::QTextureWrapMode::Repeat));
    texture->addTextureImage(new SkinImage(texture));
    return texture;
}

} // namespace chiron::scene3d
