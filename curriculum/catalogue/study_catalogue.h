// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/content_texts.h"
#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <string>
#include <string_view>
#include <vector>

namespace chiron::catalogue {

/// The studies that come with the program (content/studies/*.json). Immutable, any thread.
class StudyCatalogue {
public:
    /// From this content folder, or (empty) the one that findContentDirectory() finds, with their texts in `languages`, English first.
    /// Failure: notFound, badInput with every fault.
    static core::Result<StudyCatalogue> load(const std::string& contentDirectory = {}, const std::vector<std::string>& languages = core::languageIds());

    const std::vector<psychophysics::StudyDesign>& studies() const noexcept { return m_studies; } ///< by id
    const psychophysics::StudyDesign* find(std::string_view id) const noexcept;                   ///< nullptr: none
    /// Texts that a language lacks, where the folder has files of languages: no fault, English is shown.
    const std::vector<MissingText>& missingTexts() const noexcept { return m_missingTexts; }

private:
    std::vector<psychophysics::StudyDesign> m_studies;
    std::vector<MissingText> m_missingTexts;
};

} // namespace chiron::catalogue
