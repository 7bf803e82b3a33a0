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

/// Something in a text of a design that its settings contradict: a template's sentence after a field was changed, or a condition's title with the reference of
/// the one that it was copied from.
struct FalseClaim {
    enum class Where { aim, instructions, title, part };
    Where where = Where::aim;
    int condition = -1;   ///< of a title, or of what participants read before a part
    QString language;     ///< of the text: "en"
    QString said;         ///< the words in the text: "60 N/m"
    QString setting;      ///< what is set instead, as a phrase: "the reference is 120 N/m"
};

/// Numbers with units in titles; and in the aim, the researcher's own sentences and those of a condition the number of objects and trials, seconds, the criterion, and whether objects are
/// seen, against the settings; in each language of a text. What it does not understand it lets stand. `locale`: of the phrases.
std::vector<FalseClaim> falseClaims(const psychophysics::StudyDesign& design, const QLocale& locale);

/// "“60 N/m” (English): the reference is 120 N/m. Change the text or the setting."
QString claimWords(const FalseClaim& claim);

/// The field of the designer that a text stands in.
QString fieldOf(FalseClaim::Where where);

/// What is said falsely in one place, kept true while the draft changes; hidden where there is nothing. `condition`: -1 for none. GUI thread.
QWidget* claimsNotice(const DesignPage& page, FalseClaim::Where where, int condition = -1);

} // namespace chiron::desktop
