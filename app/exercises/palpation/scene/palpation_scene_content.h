// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/scene/finding_pins.h"
#include "app/exercises/palpation/scene/finger.h"
#include "app/exercises/palpation/scene/map_card.h"
#include "app/exercises/palpation/scene/palpation_dial.h"
#include "desktop/scene3d/plugin/scene_content.h"
#include "simulation/palpation/tissue_surface.h"

#include <array>

namespace chiron::scene3d {

/// A tissue in the opening of the drape, the fingers that search it, the findings, and the map of where the
/// fingers were.
class PalpationContent final : public ISceneContent {
public:
    PalpationContent(const SceneSetup& setup, SharedLight& light, Qt3DCore::QEntity* parent);

    void change(const SceneSetup& setup) override;
    void show(const SceneState& state) override;
    void warm() override;
    double groundHeight_m(double x_m, double y_m) const override {
        return m_surface.heightAt({x_m, y_m}).z_m;
    }
    ContentFrame frame() const override;
    ForceBars bars(const SceneSetup& setup, const SceneState& state) const override {
        return {forceDial(setup, state.exercise.of<simulation::PalpationCues>())};
    }
    void putOn(const SceneLayers& layers) override;
    void setPicture(const QSize& size_px, double ratio) override { m_card->setPicture(size_px, ratio); }

private:
    double fieldRadius_m() const;
    Qt3DRender::QParameter* parameter(const char* name, const QVariant& value);
    void makeTissue();
    void chooseLook();
    Qt3DRender::QEffect* look(bool map) const;
    void showTouch(const SceneState& state);
    void showLumps(const SceneState& state);
    void showMap(const SceneState& state);
    void showFingers(const SceneState& state);

    SceneSetup m_setup;
    simulation::PalpationParameters m_parameters;
    simulation::TissueSurface m_surface;
    SharedLight& m_light;
    Qt3DCore::QEntity* m_root;
    Qt3DRender::QParameter* m_dentPlace;
    Qt3DRender::QParameter* m_dentNormal;
    Qt3DRender::QParameter* m_tips;
    Qt3DRender::QParameter* m_presses;
    Qt3DRender::QParameter* m_skin;
    Qt3DRender::QParameter* m_lumpsNear;
    Qt3DRender::QParameter* m_lumpsFar;
    Qt3DRender::QParameter* m_border;
    Part* m_tissue = nullptr;
    Part* m_area = nullptr;
    PaintedFace* m_map;
    MapCard* m_card;
    FindingPins* m_pins;
    GhostFinger* m_ghost;
    std::array<Finger*, core::kMaxTools> m_fingers{};
    int m_tools = 0; ///< number of fingers that cast a shadow
    int m_lumps = 0; ///< number of lumps drawn
    bool m_mapShown = false;
    bool m_mapPainted = false;
    bool m_warm = false;
    std::uint32_t m_mapStep = 0;
    simulation::SurfaceMapKind m_mapKind = simulation::SurfaceMapKind::coverage;
};

} // namespace chiron::scene3d
