// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/content_texts.h"
#include "catalogue/exercise.h"
#include "catalogue/object_content.h"
#include "catalogue/tissue_content.h"
#include "core/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace chiron::catalogue {

/// Everything in curriculum/content, checked against its schema and against what the code knows.
///
/// Failure (badInput): `file:line:column: $.json.path: value: expected ...`, one line for each fault found.
/// Thread: load on any thread; afterwards read-only.
class Catalogue {
public:
    /// Reads `directory` (with exercises/ and schema/ in it), whose texts may be in `languages`, English first.
    static core::Result<Catalogue> load(const std::string& directory, const std::vector<std::string>& languages = core::languageIds());

    const std::vector<Exercise>& exercises() const { return m_exercises; }
    const Exercise* find(std::string_view exercise) const;
    const ExerciseLevel* find(std::string_view exercise, int level) const;
    const std::vector<ContentObject>& objects() const { return m_objects; } ///< content/objects, by id
    const std::vector<ContentMesh>& meshes() const { return m_meshes; }     ///< content/meshes, by id
    const std::vector<ContentTissue>& tissues() const { return m_tissues; } ///< content/tissues, by id
    const ContentObject* findObject(std::string_view id) const;
    const ContentMesh* findMesh(std::string_view id) const;
    const ContentTissue* findTissue(std::string_view id) const;
    const std::string& directory() const { return m_directory; }
    /// Texts of exercises, objects, meshes and tissues that a language lacks: no fault, English is shown.
    const std::vector<MissingText>& missingTexts() const { return m_missingTexts; }

private:
    std::string m_directory;
    std::vector<Exercise> m_exercises;
    std::vector<ContentObject> m_objects;
    std::vector<ContentMesh> m_meshes;
    std::vector<ContentTissue> m_tissues;
    std::vector<MissingText> m_missingTexts;
};

/// The content folder: `explicitDirectory` if not empty, else the environment's CHIRON_CONTENT, else the
/// installed share folder, else the source tree. Failure: notFound, naming every place looked at.
core::Result<std::string> findContentDirectory(const std::string& explicitDirectory = {});

/// A level from the canonical JSON that a session stored. Reads no file: editing a level later changes no old
/// score and no old replay. The result's resolvedJson and resolvedSha256 are those of the bytes given. Types
/// are checked, ranges not: today's schema must not refuse yesterday's session. A parameter made since then
/// is absent and leaves the struct's default. Failure (badInput): not JSON, another format number, an unknown
/// parameter (a newer program's), or a key missing or of the wrong type, with its path. Thread: any.
core::Result<ExerciseLevel> fromResolvedJson(std::string_view json);

/// The level with no more than so many trials (at least 1): to be tried. Unchanged where it has no more, or has no trials to count. Failure:
/// as fromResolvedJson. Thread: any.
core::Result<ExerciseLevel> withTrials(const ExerciseLevel& level, int most);

/// The task's digest: SHA-256 (lower-case hex) of a level's canonical JSON without its titles and other texts. Two levels with the same one feel
/// the same and are judged alike, whatever their texts say in whichever languages. `resolvedJson` may be of any version, for a session stores its
/// own: what was stored when texts stood in the level files has the task's digest of today's files. Empty: not the JSON of a level. Thread: any.
std::string taskSha256(std::string_view resolvedJson);

} // namespace chiron::catalogue
