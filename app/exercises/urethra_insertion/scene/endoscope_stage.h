// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/endoscope_graph.h"
#include "app/exercises/urethra_insertion/scene/landmark_marks.h"
#include "app/exercises/urethra_insertion/scene/notice.h"
#include "app/exercises/urethra_insertion/scene/overview.h"
#include "app/exercises/urethra_insertion/scene/picture_marks.h"
#include "app/exercises/urethra_insertion/scene/scope_picture.h"
#include "app/exercises/urethra_insertion/scene/urethra_model.h"
#include "desktop/scene3d/plugin/force_gauge.h"
#include "desktop/scene3d/plugin/note_card.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/plugin/stage.h"

namespace chiron::scene3d {

/// The endoscopic stage: the round picture of the camera at the tip of tool 0, marks over it, the overview
/// from outside if the level has one, and the force bar.
class EndoscopeStage final : public IStage {
public:
    EndoscopeStage(const SceneSetup& setup, QObject* surface);

    Qt3DCore::QEntity* root() override { return m_root; }
    void change(const SceneSetup& setup) override;
    void show(const SceneState& state) override;
    void warm() override {}
    void setPicture(const QSize& size_px, double ratio) override;

private:
    void place();

    SceneSetup m_setup;
    QSize m_size_px{1024, 768};
    double m_ratio = 1.0;
    Qt3DCore::QEntity* m_root; ///< the engine deletes it and everything below it
    SharedLight m_light;
    EndoscopeGraph m_graph;
    UrethraModel m_model;
    ScopePicture m_picture;
    LandmarkMarks m_landmarks;
    PictureMarks m_marks;
    Notice m_notice;
    Overview m_overview;
    ForceGauge* m_gauge;
    NoteCard* m_note;
};

} // namespace chiron::scene3d
