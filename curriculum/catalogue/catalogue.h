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

/// Holds everything in curriculum/content, checked against its schemas and against what the code knows.
/// Thread: load on any thread; read-only afterwards.
/// Errors: badInput, one line `file:line:column: $.json.path: value: expected ...` for each fault found.
class Catalogue {
public:
    /// Reads `directory`, which contains exercises/ and schema/. `languages` lists the languages that the
    /// texts may be in, English first.
    static core::Result<Catalogue> load(const std::string& directory,
                                        const std::vector<std::string>& languages = core::languageIds());

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
    /// Texts of exercises, objects, meshes and tissues that a language lacks. This is not a fault: English is
    /// shown instead.
    const std::vector<MissingText>& missingTexts() const { return m_missingTexts; }

private:
    std::string m_directory;
    std::vector<Exercise> m_exercises;
    std::vector<ContentObject> m_objects;
    std::vector<ContentMesh> m_meshes;
    std::vector<ContentTissue> m_tissues;
    std::vector<MissingText> m_missingTexts;
};

/// Returns the content folder: `explicitDirectory` if it is not empty, else CHIRON_CONTENT from the
/// environment, else the installed share folder, else the source tree.
/// Errors: notFound, naming every place that was searched.
core::Result<std::string> findContentDirectory(const std::string& explicitDirectory = {});

/// Reads a level from the canonical JSON that a session stored. It reads no file, so that editing a level
/// later changes no old score and no old replay. The result's resolvedJson and resolvedSha256 are those of
/// the bytes given. Types are checked but ranges are not, because today's schema must not refuse yesterday's
/// session. A parameter that was added since then is absent and keeps the struct's default.
/// Thread: any.
/// Errors: badInput, with the path: not JSON, another format number, an unknown parameter (from a newer
/// program), or a key that is missing or has the wrong type.
core::Result<ExerciseLevel> fromResolvedJson(std::string_view json);

/// Returns the level with at most `most` trials (at least 1), for trying it out. A level that has no more
/// trials than that, or no trials to count, is returned unchanged.
/// Thread: any.
/// Errors: as fromResolvedJson.
core::Result<ExerciseLevel> withTrials(const ExerciseLevel& level, int most);

/// Returns the digest of the task: the SHA-256 (lower-case hex) of a level's canonical JSON without its
/// titles and other texts. Two levels with the same digest feel the same and are judged alike, whatever their
/// texts say in any language. `resolvedJson` may be of any version, because a session stores its own: JSON
/// that was stored while the level files still held the texts has the same task digest as today's files. The
/// result is empty if `resolvedJson` is not the JSON of a level.
/// Thread: any.
std::string taskSha256(std::string_view resolvedJson);

} // namespace chiron::catalogue
