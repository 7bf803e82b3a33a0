// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/theme/theme.h"

#include <QWidget>
#include <memory>

namespace chiron::desktop {

class LevelPicture;

/// From this scale on words need the room that a picture would take.
inline constexpr double kNoPictureScale = 1.5;

/// A picture of a level in a frame, as its exercise paints it (ExerciseFace::picture). Decorative: what it shows is said in words beside
/// it.
class ExercisePicture final : public QWidget {
    Q_OBJECT
public:
    ExercisePicture(const Theme& theme, const catalogue::ExerciseLevel& level, QSize size_px, QWidget* parent = nullptr);
    ~ExercisePicture() override;
    QSize sizeHint() const override { return m_size; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const Theme& m_theme;
    QSize m_size;
    std::unique_ptr<LevelPicture> m_picture; ///< null: a frame alone
};

} // namespace chiron::desktop
