// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/languages.h"
#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <string>
#include <vector>

namespace chiron::catalogue {

/// A published questionnaire in the form in which it is put into a study.
struct Instrument {
    psychophysics::Questionnaire questionnaire; ///< its id is the file's name
    std::string source;                         ///< the publication to cite
    std::string permission; ///< why its wording may be used, and which parts of the wording are the program's
                            ///< own
};

/// Loads the instruments that come with the program (content/instruments/*.json), ordered by file name and
/// including the enrolment fields. They come from `contentDirectory` or, if it is empty, from the folder that
/// findContentDirectory() finds. A folder without instruments yields none. `languages` lists the languages of
/// the texts, English first; a text that a language lacks is shown in English.
/// Thread: any.
/// Errors: notFound; badInput naming every fault.
core::Result<std::vector<Instrument>>
loadInstruments(const std::string& contentDirectory = {},
                const std::vector<std::string>& languages = core::languageIds());

} // namespace chiron::catalogue
