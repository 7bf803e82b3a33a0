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

/// The part of a debrief that is specific to one exercise, as read from a recording.
/// Thread: constructed on a worker, shown on the GUI thread.
class DebriefPart {
public:
    DebriefPart() = default;
    DebriefPart(const DebriefPart&) = delete;
    DebriefPart& operator=(const DebriefPart&) = delete;
    virtual ~DebriefPart() = default;

    /// Returns null if there is nothing to show because no trial was started.
    /// Thread: GUI.
    virtual std::unique_ptr<QWidget> widget(const Theme& theme, const QLocale& locale) const = 0;
};

/// Why the part could not be read although the rest of the recording is intact.
struct DebriefPartLost {
    QString words; ///< text for the user
    core::Error why;
};

/// Holds null if the exercise shows nothing of its own in a debrief.
using DebriefReading = tl::expected<std::unique_ptr<const DebriefPart>, DebriefPartLost>;

/// The translation context for the texts of these parts.
struct DebriefPartTexts {
    Q_DECLARE_TR_FUNCTIONS(ExercisePart)
};

} // namespace chiron::desktop
