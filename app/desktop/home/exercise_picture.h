// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/theme/theme.h"

#include <QWidget>
#include <memory>

namespace chiron::desktop {

class LevelPicture;

/// From this interface scale upwards the text needs the room that a picture would take.
inline constexpr double kNoPictureScale = 1.5;

/// A framed picture of a level, painted by its exercise (ExerciseFace::picture). It is decorative: the text
/// beside it says what it shows.
class ExercisePicture final : public QWidget {
    Q_OBJECT
public:
    ExercisePicture(const Theme& theme, const catalogue::ExerciseLevel& level, QSize size_px,
                    QWidget* parent = nullptr);
    ~ExercisePicture() override;
    QSize sizeHint() const override { return m_size; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const Theme& m_theme;
    QSize m_size;
    std::unique_ptr<LevelPicture> m_picture; ///< null: only the frame is drawn
};

} // namespace chiron::desktop
