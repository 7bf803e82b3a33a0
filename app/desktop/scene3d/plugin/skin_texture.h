// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt3DRender/QTexture>

namespace chiron::scene3d {

/// skinPicture() as a texture; painted by one of Qt3D's own worker threads while the window goes on.
Qt3DRender::QAbstractTexture* makeSkinTexture(Qt3DCore::QNode* parent);

} // namespace chiron::scene3d
