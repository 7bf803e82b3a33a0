// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/endoscope_layout.h"

#include <QColor>
#include <QObject>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QFrameGraphNode>
#include <Qt3DRender/QLayer>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QSubtreeEnabler>
#include <Qt3DRender/QTexture>
#include <Qt3DRender/QViewport>
#include <array>

namespace chiron::scene3d {

/// The frame graph of the endoscopic stage: in which order and into which targets it is drawn. Without depth
/// of field, the camera's picture goes straight to the window. With depth of field, pass 1 draws the picture
/// at reduced size into a colour texture (its opacity holds the sharpness of each pixel) with a depth
/// texture, pass 2 blurs that by the circle of confusion, and pass 3 draws the picture into the window and
/// mixes each pixel with its blurred value. Marks, overview and bar follow. The nodes belong to the root
/// entity.
class EndoscopeGraph {
public:
    EndoscopeGraph(Qt3DCore::QEntity* root, QObject* surface);

    void setDepthOfField(bool on);
    void setOverviewShown(bool shown);
    void place(const EndoscopeLayout& layout, const QSize& window_px);

    // Layers that determine when an entity is drawn; add them to the entities.
    /// The black round the picture; leaves the area behind it untouched.
    Qt3DRender::QLayer* mask() const { return m_layers[0]; }
    Qt3DRender::QLayer* inside() const { return m_layers[1]; } ///< view of the camera at the tip
    Qt3DRender::QLayer* blur() const { return m_layers[2]; }   ///< pass 2
    /// Over the camera's picture, in the picture's coordinates.
    Qt3DRender::QLayer* marks() const { return m_layers[3]; }
    Qt3DRender::QLayer* outside() const { return m_layers[4]; }     ///< the overview
    Qt3DRender::QLayer* glass() const { return m_layers[5]; }       ///< over the overview, translucent
    Qt3DRender::QLayer* outsideOver() const { return m_layers[6]; } ///< over those: the arrow
    Qt3DRender::QLayer* over() const { return m_layers[7]; }        ///< in the window's coordinates: the bar

    Qt3DRender::QCamera* scope() const { return m_scope; }
    Qt3DRender::QCamera* bystander() const { return m_bystander; }
    Qt3DRender::QTexture2D* seen() const { return m_seen; }
    Qt3DRender::QTexture2D* blurred() const { return m_blurred; }

    /// The side of passes 1 and 2 relative to that of the picture.
    static constexpr double kSmall = 0.33;

private:
    void makeDirect(Qt3DRender::QFrameGraphNode* parent);
    void makeDepthOfField(Qt3DRender::QFrameGraphNode* parent);
    void makeOverview(Qt3DRender::QFrameGraphNode* parent);
    void drawInside(Qt3DRender::QFrameGraphNode* parent, const char* look, Qt3DRender::QParameter* disc);
    void setDisc(Qt3DRender::QParameter* disc, double side, double left, double bottom);
    void addPass(Qt3DRender::QFrameGraphNode* parent, Qt3DRender::QLayer* layer,
                 Qt3DRender::QClearBuffers::BufferType clear = Qt3DRender::QClearBuffers::None);
    Qt3DRender::QViewport* addViewport(Qt3DRender::QFrameGraphNode* parent);
    Qt3DRender::QFrameGraphNode* addTarget(Qt3DRender::QFrameGraphNode* parent,
                                           Qt3DRender::QTexture2D* colour, Qt3DRender::QTexture2D* depth);

    std::array<Qt3DRender::QLayer*, 8> m_layers{};
    Qt3DRender::QParameter* m_disc;      ///< position of the picture in the window, for its shaders
    Qt3DRender::QParameter* m_smallDisc; ///< position of the picture in the textures
    Qt3DRender::QCamera* m_scope;
    Qt3DRender::QCamera* m_bystander;
    Qt3DRender::QTexture2D* m_seen;
    Qt3DRender::QTexture2D* m_depth;
    Qt3DRender::QTexture2D* m_blurred;
    Qt3DRender::QSubtreeEnabler* m_direct = nullptr;
    Qt3DRender::QSubtreeEnabler* m_lens = nullptr;
    Qt3DRender::QSubtreeEnabler* m_outside = nullptr;
    Qt3DRender::QViewport* m_picture[3] = {nullptr, nullptr, nullptr};
    Qt3DRender::QViewport* m_overview = nullptr;
};

} // namespace chiron::scene3d
