// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "desktop/studies/study_draft.h"
#include "desktop/widgets/kit.h"

#include <QString>
#include <functional>

namespace chiron::desktop {

class AppContext;
class FieldGrid;

/// The context that the pages of a design receive.
struct DesignPage {
    AppContext& app;
    StudyDraft& draft;
    bool readOnly = true;
    QString language = QStringLiteral("en"); ///< of the texts being edited
    database::Blinding blinding{};
    /// StudyRecord::masked: the design's conditions are codes, with the properties that all of them share.
    bool masked = false;
};

/// Adds a field for a text in the page's language. `text` locates it in a design. Clearing the field of an
/// optional text (`mayBeAbsent`) removes the text; for any other it is an error. `follow` changes what
/// follows the text, in the same step.
void addStudyText(FieldGrid& grid, const DesignPage& page, const QString& label, const QString& name,
                  int lines,
                  const std::function<psychophysics::StudyText&(psychophysics::StudyDesign&)>& text,
                  bool mayBeAbsent = false,
                  const std::function<void(psychophysics::StudyDesign&)>& follow = {});
/// Tells that the last step removed a part of the design ("The condition was removed."), and offers Undo. If
/// the design was changed since, Undo says so and changes nothing.
void tellRemoved(const DesignPage& page, const QString& what);
/// A card with a title.
kit::Box titledBox(const Theme& theme, const QString& title);

} // namespace chiron::desktop
