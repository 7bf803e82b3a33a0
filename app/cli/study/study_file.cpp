// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study/study_file.h"

#include "catalogue/study_json.h"
#include "cli/input_file.h"

#include <QFileInfo>

namespace chiron::cli {

bool isStudyFile(const QString& name) {
    // The key of a study contains neither of them.
    return (name.contains(u'/') || name.contains(u'.')) && QFileInfo(name).isFile();
}

core::Result<psychophysics::StudyDesign> readStudyFile(const QString& path) {
    constexpr qint64 kLargest = 1 << 20;
    const auto bytes = readInputFile(path, kLargest);
    CHIRON_TRY(bytes);
    return catalogue::readStudy(*bytes, path.toStdString());
}

} // namespace chiron::cli
