// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/home/exercise_picture.h"

#include "desktop/exercise_face.h"
#include "simulation/scene_parameters.h"

#include <QPainter>
#include <QPainterPath>

namespace chiron::desktop {

ExercisePicture::ExercisePicture(const Theme& theme, const catalogue::ExerciseLevel& level, QSize size_px,
                                 QWidget* parent)
    : QWidget(parent), m_theme(theme), m_size(theme.px(size_px.width()), theme.px(size_px.height())) {
    const bool shown = simulation::hasCue(level.cues, "object");
    if (const auto face = exerciseFace(level.exercise))
        m_picture = (*face)->picture(level, {theme, m_size, shown});
    setFixedSize(m_size);
    setAttribute(Qt::WA_TransparentForMouseEvents);
}

ExercisePicture::~ExercisePicture() = default;

void ExercisePicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double radius = m_theme.radius();
    QPainterPath frame;
    frame.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
    painter.setClipPath(frame);
    painter.fillPath(frame, m_theme.color(Colour::sceneBackground));
    if (m_picture)
        m_picture->paint(painter);
    painter.setClipping(false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.color(Colour::border), 1));
    painter.drawPath(frame);
}

} // namespace chiron::desktop
