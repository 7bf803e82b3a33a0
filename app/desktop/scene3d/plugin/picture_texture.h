// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <Qt3DRender/QTexture>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace chiron::scene3d {

/// Creates a repeating texture with mipmaps from a painted picture with four bytes per pixel. A thread of its
/// own paints the picture while the graphics context is being created. Textures with the same name share the
/// driver's copy, so a name must always stand for the same picture.
Qt3DRender::QAbstractTexture* makePictureTexture(const std::string& name, const QSize& size_px,
                                                 std::function<std::vector<std::uint8_t>()> paint,
                                                 Qt3DCore::QNode* parent);

} // namespace chiron::scene3d
