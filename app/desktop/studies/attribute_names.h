// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <cstddef>
#include <functional>
#include <string>

namespace chiron::desktop {

/// Makes the names follow after the attribute of a condition has changed: its title and short name, and the
/// title of the study once no condition has the former attribute. Only names that the program made follow:
/// "Stiffness" becomes "Mass", and "Tube of 60 N/m" becomes "Mass of 100 g". `before`, `referenceBefore`:
/// what the condition had, the reference in SI; `isTyped`: whether somebody typed this name.
void nameByAttribute(psychophysics::StudyDesign& design, std::size_t at, psychophysics::Attribute before,
                     double referenceBefore, const std::function<bool(const std::string&)>& isTyped);

} // namespace chiron::desktop
