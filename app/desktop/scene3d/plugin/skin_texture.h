// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt3DRender/QTexture>

namespace chiron::scene3d {

/// skinPicture() as a texture; painted by a thread of its own while the graphics context is made.
Qt3DRender::QAbstractTexture* makeSkinTexture(Qt3DCore::QNode* parent);

} // namespace chiron::scene3d
