// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/scene/tissue_look.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "simulation/palpation/map_bands.h"

#include <QSizeF>
#include <QString>
#include <vector>

class QFont;
class QPainter;
class QRectF;

namespace chiron::scene3d {

/// The card that explains the map on the tissue, in newtons, with the searched share. Coordinates are logical
/// pixels at scale 1 from the upper left corner; 3D and flat pictures use the same card.
class MapLegend {
public:
    MapLegend(const SceneSetup& setup, simulation::SurfaceMapKind kind, int percent);
    /// The legend for a state; `percent` < 0: the share is not shown.
    static MapLegend of(const SceneSetup& setup, const SceneState& state);

    void paint(QPainter& painter) const;
    QSizeF size() const;
    /// Equal legends need no repainting.
    bool operator==(const MapLegend& other) const {
        return m_kind == other.m_kind && m_percent == other.m_percent;
    }

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
