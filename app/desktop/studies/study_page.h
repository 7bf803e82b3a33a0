// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "desktop/studies/study_draft.h"
#include "desktop/widgets/kit.h"

#include <QString>

namespace chiron::desktop {

class AppContext;
class FieldGrid;

/// What the pages of a design are given.
struct DesignPage {
    AppContext& app;
    StudyDraft& draft;
    bool readOnly = true;
    QString language = QStringLiteral("en"); ///< of the texts that are edited
    database::Blinding blinding{};
    bool masked = false; ///< StudyRecord::masked: the design's conditions are codes, with what all of them share
};

/// Adds a field for a text in the page's language. `text` finds it in a design. A text that may be absent is so when its field is emptied;
/// any other has an error then.
void addStudyText(FieldGrid& grid, const DesignPage& page, const QString& label, const QString& name, int lines,
                  const std::function<psychophysics::StudyText&(psychophysics::StudyDesign&)>& text, bool mayBeAbsent = false);
/// A card with a title.
kit::Box titledBox(const Theme& theme, const QString& title);

} // namespace chiron::desktop
