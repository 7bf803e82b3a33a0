// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/sound_cues.h"
#include "desktop/theme/theme.h"

#include <QWidget>

class QLabel;

namespace chiron::desktop {

class SoundGlyph;

/// What a level lets be heard, to be seen: contact begins (a dot that lights up), how high the tone is (six steps that rise) and the
/// warning (a triangle), with the same in words. For levels that have sound but no bars: steps as coarse as these tell no
/// more than the pitch does, and no numbers. Shown whether somebody hears it or has switched it off. GUI thread.
class SoundSign final : public QWidget {
    Q_OBJECT
public:
    static constexpr int kSteps = 6; ///< of the force limit: a third of an octave each

    explicit SoundSign(const Theme& theme, QWidget* parent = nullptr);

    /// Each frame. `sounding`: the cues sound now, or would if nobody had switched them off. `now_ns`: of the display state.
    void show(const SoundCues& cues, bool sounding, std::int64_t now_ns);
    QString words() const;
    /// How many steps a force lights: none without contact, at least one with it, all at the limit. Pure.
    static int stepsOf(double force_N, double limit_N);

private:
    SoundGlyph* m_glyph;
    QLabel* m_words;
    std::uint32_t m_contacts = 0;
    std::int64_t m_clicked_ns = -1; ///< when contact began last; −1: nothing is lit
};

} // namespace chiron::desktop
