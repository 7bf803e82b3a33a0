// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <string>
#include <string_view>
#include <vector>

namespace chiron::catalogue {

/// The studies that come with the program (content/studies/*.json). Immutable, any thread.
class StudyCatalogue {
public:
    /// From this content folder, or (empty) the one that findContentDirectory() finds. Failure: notFound, badInput with every fault.
    static core::Result<StudyCatalogue> load(const std::string& contentDirectory = {});

    const std::vector<psychophysics::StudyDesign>& studies() const noexcept { return m_studies; } ///< by id
    const psychophysics::StudyDesign* find(std::string_view id) const noexcept;                   ///< nullptr: none

private:
    std::vector<psychophysics::StudyDesign> m_studies;
};

} // namespace chiron::catalogue
