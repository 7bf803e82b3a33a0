// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "app/exercises/palpation/scene/tissue_look.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"
#include "simulation/palpation/map_bands.h"

#include <QSizeF>
#include <QString>
#include <vector>

class QFont;
class QPainter;
class QRectF;

namespace chiron::scene3d {

/// The card that says what the map on the tissue means, in newtons, with the share that was searched. Logical pixels at scale 1,
/// from the upper left corner; the same in 3D and flat.
class MapLegend {
public:
    MapLegend(const SceneSetup& setup, simulation::SurfaceMapKind kind, int percent);
    /// What a state asks for; `percent` < 0: it does not say.
    static MapLegend of(const SceneSetup& setup, const SceneState& state);

    void paint(QPainter& painter) const;
    QSizeF size() const;
    /// Whether another one has to be painted.
    bool operator==(const MapLegend& other) const { return m_kind == other.m_kind && m_percent == other.m_percent; }

private:
    struct Row {
        simulation::MapBand band;
        QString words;
    };
    QString title() const;
    std::vector<Row> rows() const;
    void paintSwatch(QPainter& painter, const QRectF& box, simulation::MapBand band) const;
    QFont font(double size, bool bold) const;

    SceneSetup m_setup;
    simulation::SurfaceMapKind m_kind;
    int m_percent;
};

/// The colour of bare tissue, for swatches and flat pictures.
QColor tissueColour(TissueLook look);

} // namespace chiron::scene3d
