// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <QString>

namespace chiron::cli {

/// Whether what the user calls a study is a file: it has the look of a path ("./a.json", "a.json") and is there.
bool isStudyFile(const QString& name);

/// A study's design from a JSON file of at most 1 MiB. Failure: badInput naming the place in the file.
core::Result<psychophysics::StudyDesign> readStudyFile(const QString& path);

} // namespace chiron::cli
