// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/sound_cues.h"
#include "desktop/theme/theme.h"

#include <QWidget>

class QLabel;

namespace chiron::desktop {

class SoundGlyph;

/// Makes a level's sound cues visible: contact (a dot that lights up), the pitch of the tone (six rising
/// steps) and the warning (a triangle), with the same in words. It is for levels with sound but without bars:
/// such coarse steps reveal no more than the pitch does, and no numbers. It is shown whether or not the sound
/// is switched on.
/// Thread: GUI.
class SoundSign final : public QWidget {
    Q_OBJECT
public:
    static constexpr int kSteps = 6; ///< up to the force limit: a third of an octave each

    explicit SoundSign(const Theme& theme, QWidget* parent = nullptr);

    /// Call once per frame. `sounding`: the cues are audible now, or would be if nobody had switched them
    /// off. `now_ns` is that of the display state.
    void show(const SoundCues& cues, bool sounding, std::int64_t now_ns);
    QString words() const;
    /// The number of steps that a force lights: none without contact, at least one with contact, all at the
    /// limit. Pure.
    static int stepsOf(double force_N, double limit_N);

private:
    SoundGlyph* m_glyph;
    QLabel* m_words;
    std::uint32_t m_contacts = 0;
    std::int64_t m_clicked_ns = -1; ///< time of the last contact; −1: the dot is not lit
};

} // namespace chiron::desktop
