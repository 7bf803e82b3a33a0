// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/theme/theme.h"

#include <QWidget>
#include <optional>

namespace chiron::desktop {

/// From this scale on words need the room that a picture would take.
inline constexpr double kNoPictureScale = 1.5;

/// A picture of a level, painted from its content: the ball in its true proportions, dashed where it is not shown, its dimple
/// where it has one, and the instrument on its apex; or the urethra from the side with its narrow places, the bladder with its
/// landmarks, and the endoscope before it; or the tube with what holds it; or the objects, their dish and a grasper; or the tissue's
/// true outline under a finger, its lump where it is shown. Decorative: what it shows is said in words beside it.
class ExercisePicture final : public QWidget {
    Q_OBJECT
public:
    ExercisePicture(const Theme& theme, const catalogue::ExerciseLevel& level, QSize size_px, QWidget* parent = nullptr);
    QSize sizeHint() const override { return m_size; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintBall(QPainter& painter, QPointF centre, double radius) const;
    void paintSphereApex(QPainter& painter) const;
    void paintUrethra(QPainter& painter) const;
    void paintTube(QPainter& painter) const;
    void paintHandling(QPainter& painter) const;
    void paintPalpation(QPainter& painter) const;
    void paintFinger(QPainter& painter, QPointF tip, bool fromLeft, double perMetre) const;
    void paintFloor(QPainter& painter, double y) const;
    void paintGrasper(QPainter& painter, QPointF tip, QPointF from, double opening) const;
    void paintTool(QPainter& painter, QPointF tip, double length) const;

    const Theme& m_theme;
    QSize m_size;
    simulation::SphereApexParameters m_ball;
    std::optional<simulation::UrethraInsertionParameters> m_urethra;
    std::optional<simulation::ElasticTubeParameters> m_tube;
    std::optional<simulation::ObjectHandlingParameters> m_handling;
    std::optional<simulation::PalpationParameters> m_palpation;
    bool m_visible = true;
};

} // namespace chiron::desktop
