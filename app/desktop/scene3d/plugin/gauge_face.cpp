// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/gauge_face.h"

#include <QPainter>
#include <cmath>

namespace chiron::scene3d {

void GaugeFace::change(const SceneSetup& setup, const GaugeDial& dial, double unit_px) {
    m_setup = setup;
    m_dial = dial;
    m_unit_px = unit_px;
    setSize(QSize(int(std::ceil(GaugePainter::kWidth * unit_px)),
                  int(std::ceil(GaugePainter::kHeight * unit_px))));
    update();
}

void GaugeFace::paint(QPainter* painter) {
    painter->setCompositionMode(QPainter::CompositionMode_Source);
    painter->fillRect(QRect(QPoint(0, 0), size()), Qt::transparent);
    painter->setCompositionMode(QPainter::CompositionMode_SourceOver);
    painter->scale(m_unit_px, m_unit_px);
    GaugePainter(m_setup, m_dial).paint(*painter);
}

} // namespace chiron::scene3d
