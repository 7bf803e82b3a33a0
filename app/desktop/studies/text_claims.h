// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <QLocale>
#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

namespace chiron::desktop {

struct DesignPage;

/// A statement in a text of a design that contradicts its settings, such as a template's sentence after a
/// field was changed, or a copied condition's title that still names the original's reference.
struct FalseClaim {
    enum class Where { aim, instructions, title, part };
    Where where = Where::aim;
    int condition = -1; ///< of a title, or of the text before a part
    QString language;   ///< of the text: "en"
    QString said;       ///< the words in the text: "60 N/m"
    QString setting;    ///< the actual setting as a phrase: "the reference is 120 N/m"
};

/// Finds such statements in each language of a text. In titles it checks numbers with units. In the aim, the
/// researcher's own sentences and those of a condition it checks the numbers of objects and trials, seconds,
/// the criterion, and whether objects are visible. It ignores what it does not understand. `locale` is that
/// of the phrases.
std::vector<FalseClaim> falseClaims(const psychophysics::StudyDesign& design, const QLocale& locale);

/// "“60 N/m” (English): the reference is 120 N/m. Change the text or the setting."
QString claimWords(const FalseClaim& claim);

/// The designer's field that contains a text.
QString fieldOf(FalseClaim::Where where);

/// A notice about false statements in one place, updated while the draft changes; hidden if there are none.
/// `condition`: -1 for none.
/// Thread: GUI.
QWidget* claimsNotice(const DesignPage& page, FalseClaim::Where where, int condition = -1);

} // namespace chiron::desktop
