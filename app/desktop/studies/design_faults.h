// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <QLocale>
#include <QMap>
#include <QString>
#include <vector>

namespace chiron::desktop {

/// An error in a design, and the place where the researcher can correct it.
struct DesignFault {
    int tab = 0;        ///< a StudyScreen::Tab
    int condition = -1; ///< index on the conditions' page; -1: no condition
    QString field;      ///< object name of the field; empty: none
    QString words;
};

/// The errors that catalogue::readStudy found, assigned to their fields and described with units, in the
/// order of the pages.
std::vector<DesignFault> designFaults(const psychophysics::StudyDesign& design, const core::Error& error,
                                      const QLocale& locale);

/// Errors in a design that is formally valid: conditions with the same name.
std::vector<DesignFault> nameFaults(const psychophysics::StudyDesign& design);

/// The errors of one page, by field.
QMap<QString, QString> faultsOfPage(const std::vector<DesignFault>& faults, int tab, int condition);

} // namespace chiron::desktop
