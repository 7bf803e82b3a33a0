// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/flat_urethra.h"

#include "app/exercises/urethra_insertion/scene/endoscope_layout.h"
#include "app/exercises/urethra_insertion/scene/flat_profile.h"
#include "app/exercises/urethra_insertion/scene/flat_scope_picture.h"

#include <QCoreApplication>
#include <QPainter>

namespace chiron::scene3d {

QString FlatUrethra::name() const {
    return QCoreApplication::translate("chiron::scene3d::FlatUrethra",
                                       "The endoscope's picture, and the canal from the side");
}

bool FlatUrethra::paintWhole(QPainter& painter, const QRectF& room, const SceneSetup& setup,
                             const SceneState& state) const {
    const EndoscopeLayout layout = EndoscopeLayout::of(room.size().toSize(), 0, setup.cues.overview);
    const QRectF picture = QRectF(layout.picture).translated(room.topLeft());
    painter.fillRect(setup.cues.overview ? picture : room, Qt::black);
    FlatScopePicture(m_drawing, setup).paint(painter, picture, state);
    if (setup.cues.overview) {
        const QRectF overview = QRectF(layout.overview).translated(room.topLeft());
        FlatProfile(m_drawing, setup)
            .paint(painter, overview.adjusted(6.0 * setup.scale, 0.0, 0.0, 0.0), state);
    }
    return true;
}

std::vector<std::string> FlatUrethra::marks(const simulation::UrethraInsertionParameters& parameters,
                                            const MarkedScene& scene) {
    std::vector<std::string> marks; // the picture has no surrounding stage
    if (scene.setup.cues.object && scene.setup.cues.guidance) {
        marks.push_back("lumen_ring");
        if (!parameters.landmarks.empty())
            marks.push_back("landmark_rings");
    }
    if (scene.setup.cues.arrow)
        marks.push_back("force_across");
    if (scene.setup.cues.overview)
        marks.push_back("overview");
    return marks;
}

} // namespace chiron::scene3d
