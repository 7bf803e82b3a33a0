// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/skin_texture.h"

#include "desktop/scene3d/parts/skin_picture.h"
#include "desktop/scene3d/plugin/picture_texture.h"

namespace chiron::scene3d {

namespace {
constexpr int kSide_px = 512;
}

Qt3DRender::QAbstractTexture* makeSkinTexture(Qt3DCore::QNode* parent) {
    return makePictureTexture(
        "skin", QSize(kSide_px, kSide_px), [] { return skinPicture(kSide_px); }, parent);
}

} // namespace chiron::scene3d
