// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/scene_setup.h"

#include <QSize>
#include <QVector3D>
#include <QVector4D>
#include <Qt3DRender/QParameter>
#include <algorithm>

namespace chiron::scene3d {

/// Shared by the materials of a scene: the effects, and the parameters for the lamp, the size of the picture
/// and high contrast.
struct SharedLight {
    explicit SharedLight(Qt3DCore::QNode* parent)
        : effects(parent), lamp(new Qt3DRender::QParameter(
                               QStringLiteral("lamp"), QVector3D(-0.30F, 0.22F, 0.93F).normalized(), parent)),
          lens(new Qt3DRender::QParameter(QStringLiteral("lens"), QVector4D(0, 0, 0, 0), parent)),
          outlined(new Qt3DRender::QParameter(QStringLiteral("outlined"), 0.0F, parent)) {}

    void change(const SceneSetup& setup) {
        outlined->setValue(setup.colours.highContrast ? 1.0F : 0.0F);
        m_vignette = setup.colours.highContrast ? 0.0F : 0.14F;
        setSize_px(m_size_px);
    }
    /// In device pixels.
    void setSize_px(const QSize& size) {
        m_size_px = size;
        lens->setValue(QVector4D(2.0F / float(std::max(1, size.width())),
                                 2.0F / float(std::max(1, size.height())), m_vignette, 0.0F));
    }

    EffectShelf effects;
    Qt3DRender::QParameter* lamp;
    Qt3DRender::QParameter* lens;
    Qt3DRender::QParameter* outlined;

private:
    QSize m_size_px{1, 1};
    float m_vignette = 0.0F;
};

} // namespace chiron::scene3d
