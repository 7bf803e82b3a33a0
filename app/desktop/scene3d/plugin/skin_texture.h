// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt3DRender/QTexture>

namespace chiron::scene3d {

/// Returns skinPicture() as a texture. A thread of its own paints it while the graphics context is being
/// created.
Qt3DRender::QAbstractTexture* makeSkinTexture(Qt3DCore::QNode* parent);

} // namespace chiron::scene3d
