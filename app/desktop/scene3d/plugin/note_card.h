// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/painted_face.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/scene_note.h"
#include "desktop/scene3d/scene_setup.h"

#include <Qt3DCore/QEntity>

namespace chiron::scene3d {

/// A note over the whole picture. It is painted when it changes, and costs nothing while there is none.
class NoteCard final : public Qt3DCore::QEntity {
public:
    NoteCard(SharedLight& light, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup);
    /// Sets the size of the picture in device pixels and the number of device pixels per logical pixel.
    void setPicture(const QSize& size_px, double ratio);
    void show(const SceneNote& note);

private:
    void repaint();

    SceneSetup m_setup;
    SceneNote m_note;
    QSize m_picture_px{1024, 768};
    double m_ratio = 1.0;
    PaintedFace* m_face;
};

} // namespace chiron::scene3d
