// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <QLocale>
#include <QMap>
#include <QString>
#include <vector>

namespace chiron::desktop {

/// Something wrong with a design, where a researcher can put it right.
struct DesignFault {
    int tab = 0;        ///< StudyScreen::Tab
    int condition = -1; ///< of the conditions' page; -1: of no condition
    QString field;      ///< object name of the field; empty: of none
    QString words;
};

/// What catalogue::readStudy found wrong, at the fields that hold it and in words with units, in the order of the pages.
std::vector<DesignFault> designFaults(const psychophysics::StudyDesign& design, const core::Error& error, const QLocale& locale);

/// What reads well and is wrong all the same: conditions that have the same name.
std::vector<DesignFault> nameFaults(const psychophysics::StudyDesign& design);

/// Those of a page, by field.
QMap<QString, QString> faultsOfPage(const std::vector<DesignFault>& faults, int tab, int condition);

} // namespace chiron::desktop
