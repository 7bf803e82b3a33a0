// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/urethra_insertion/endoscope_graph.h"
#include "desktop/scene3d/urethra_insertion/thin_lens.h"
#include "desktop/scene3d/urethra_insertion/urethra_model.h"

namespace chiron::scene3d {

/// What the camera at the tip of tool 0 sees: the walls in its own light, the black round the picture, and the two passes of
/// the depth of field.
class ScopePicture {
public:
    ScopePicture(const UrethraModel& model, EffectShelf& effects, EndoscopeGraph& graph, Qt3DCore::QEntity* root);

    void change(const SceneSetup& setup);
    /// `shown` false: black.
    void show(const ToolView& tool, bool shown);
    /// The picture in the window (from the window's upper left corner), device pixels.
    void place(const QRect& picture, const QSize& window_px);
    /// Where things of A stand; marks on the walls go below it.
    Qt3DCore::QEntity* anatomy() const { return m_anatomy; }

private:
    Qt3DRender::QMaterial* lining(const char* vertexShader, Qt3DRender::QAbstractTexture* picture,
                                  const QVector3D& pale, const QVector3D& red, float rough, float wet,
                                  const core::Vec3& axis_A);
    void makePasses();
    void aimLens();

    const UrethraModel& m_model;
    EffectShelf& m_effects;
    EndoscopeGraph& m_graph;
    Qt3DCore::QEntity* m_root;
    Qt3DCore::QEntity* m_anatomy;
    Qt3DRender::QParameter* m_lamp;
    Qt3DRender::QParameter* m_disc;
    Qt3DRender::QParameter* m_sharpness;
    Qt3DRender::QParameter* m_reach;
    Qt3DRender::QParameter* m_corner;
    ThinLens m_lens;
    double m_metered_mm = UrethraDrawing::kNear_m * 1e3;
    bool m_depthOfField = false;
    QRect m_picture{0, 0, 2, 2};
    QSize m_window_px{2, 2};
};

} // namespace chiron::scene3d
