// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/theme/theme.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <memory>

class QWidget;

namespace chiron::desktop {

/// The part of a debrief that only one exercise has, as read from a recording. Made on a worker, shown on the GUI thread; knows neither.
class DebriefPart {
public:
    DebriefPart() = default;
    DebriefPart(const DebriefPart&) = delete;
    DebriefPart& operator=(const DebriefPart&) = delete;
    virtual ~DebriefPart() = default;

    /// Null where there is nothing to show: no trial was begun. GUI thread.
    virtual std::unique_ptr<QWidget> widget(const Theme& theme, const QLocale& locale) const = 0;
};

/// Why the part could not be read, although the rest of the recording holds.
struct DebriefPartLost {
    QString words; ///< for people
    core::Error why;
};

/// Null: the exercise shows nothing of its own there.
using DebriefReading = tl::expected<std::unique_ptr<const DebriefPart>, DebriefPartLost>;

/// The translation context of what these parts say.
struct DebriefPartTexts {
    Q_DECLARE_TR_FUNCTIONS(ExercisePart)
};

} // namespace chiron::desktop
