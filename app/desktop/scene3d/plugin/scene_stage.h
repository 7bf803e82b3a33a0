// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/force_arrow.h"
#include "desktop/scene3d/plugin/force_gauge.h"
#include "desktop/scene3d/plugin/instrument.h"
#include "desktop/scene3d/plugin/note_card.h"
#include "desktop/scene3d/plugin/place_marks.h"
#include "desktop/scene3d/plugin/scene_content.h"
#include "desktop/scene3d/plugin/stage.h"
#include "desktop/scene3d/plugin/yield_marks.h"

#include <QObject>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QLayer>
#include <array>
#include <memory>
#include <optional>

namespace chiron::scene3d {

/// The laparoscopic stage and its drawing order: field and instruments, then the ghost, and over everything
/// the arrow and the bar.
class SceneStage final : public IStage {
public:
    SceneStage(const SceneSetup& setup, QObject* surface);

    Qt3DCore::QEntity* root() override { return m_root; }
    void change(const SceneSetup& setup) override;
    void show(const SceneState& state) override;
    void warm() override { m_content->warm(); }
    void setPicture(const QSize& size_px, double ratio) override;

private:
    void makeFrameGraph(QObject* surface);
    void makeDrape();
    void aim();
    void showForce(const GaugeDial& dial, const SceneState& state);
    void showSecond(const std::optional<SecondBar>& bar);
    void placeSecond();

    SceneSetup m_setup;
    QSize m_size_px{1024, 768};
    Qt3DCore::QEntity* m_root; ///< the engine deletes it and everything below it
    SharedLight m_light;
    Qt3DRender::QCamera* m_camera;
    Qt3DRender::QLayer* m_ghostLayer;
    Qt3DRender::QLayer* m_overLayer;
    Qt3DRender::QParameter* m_cloth;
    YieldMarks m_yields;
    Qt3DRender::QClearBuffers* m_clear = nullptr;
    std::unique_ptr<ISceneContent> m_content;
    ContentFrame m_frame; ///< of the content
    std::array<Instrument*, core::kMaxTools> m_instruments{};
    std::array<ForceArrow*, core::kMaxTools> m_arrows{};
    Instrument* m_ghost = nullptr;
    PlaceMarks* m_marks = nullptr;
    ForceGauge* m_gauge = nullptr;
    NoteCard* m_note = nullptr;
    ForceGauge* m_second = nullptr; ///< the exercise's second force
    GaugeDial m_forceDial;          ///< includes the band, if there is one
    std::optional<GaugeDial> m_dial;
    bool m_dialShown = false;
};

} // namespace chiron::scene3d
