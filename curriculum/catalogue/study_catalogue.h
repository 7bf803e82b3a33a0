// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/content_texts.h"
#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <string>
#include <string_view>
#include <vector>

namespace chiron::catalogue {

/// The studies that come with the program (content/studies/*.json). Immutable.
/// Thread: any.
class StudyCatalogue {
public:
    /// Loads from this content folder or, if it is empty, from the one that findContentDirectory() finds.
    /// `languages` lists the languages of the texts, English first.
    /// Errors: notFound; badInput naming every fault.
    static core::Result<StudyCatalogue> load(const std::string& contentDirectory = {},
                                             const std::vector<std::string>& languages = core::languageIds());

    const std::vector<psychophysics::StudyDesign>& studies() const noexcept { return m_studies; } ///< by id
    /// Returns nullptr if there is none.
    const psychophysics::StudyDesign* find(std::string_view id) const noexcept;
    /// Texts that a language lacks, if the folder has language files. This is not a fault: English is shown
    /// instead.
    const std::vector<MissingText>& missingTexts() const noexcept { return m_missingTexts; }

private:
    std::vector<psychophysics::StudyDesign> m_studies;
    std::vector<MissingText> m_missingTexts;
};

} // namespace chiron::catalogue
