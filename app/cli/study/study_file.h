// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <QString>

namespace chiron::cli {

/// True if the user's name of a study refers to a file: it looks like a path ("./a.json", "a.json") and the
/// file exists.
bool isStudyFile(const QString& name);

/// Reads a study's design from a JSON file of at most 1 MiB.
/// Errors: badInput naming the place in the file.
core::Result<psychophysics::StudyDesign> readStudyFile(const QString& path);

} // namespace chiron::cli
