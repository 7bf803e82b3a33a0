// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <Qt3DRender/QTexture>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace chiron::scene3d {

/// A painted picture, four bytes a pixel, as a repeating texture with smaller copies of itself; painted by a thread of its own
/// while the graphics context is made. Two textures of one name share the driver's copy: a name stands for one picture.
Qt3DRender::QAbstractTexture* makePictureTexture(const std::string& name, const QSize& size_px,
                                                 std::function<std::vector<std::uint8_t>()> paint,
                                                 Qt3DCore::QNode* parent);

} // namespace chiron::scene3d
