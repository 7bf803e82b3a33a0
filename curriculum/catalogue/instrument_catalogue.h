// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/languages.h"
#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <string>
#include <vector>

namespace chiron::catalogue {

/// A questionnaire that others have published, as it is put into a study.
struct Instrument {
    psychophysics::Questionnaire questionnaire; ///< its id is the file's name
    std::string source;     ///< whom to cite
    std::string permission; ///< why its words may be used, and which of them are the program's own
};

/// The instruments that come with the program (content/instruments/*.json), by name of file; the enrolment fields among them. From this
/// content folder, or (empty) the one that findContentDirectory() finds; a folder without instruments has none. Their texts are in `languages`,
/// English first; one that a language lacks is shown in English. Any thread. Failure: notFound, badInput with every fault.
core::Result<std::vector<Instrument>> loadInstruments(const std::string& contentDirectory = {},
                                                      const std::vector<std::string>& languages = core::languageIds());

} // namespace chiron::catalogue
