// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"

#include "catalogue/content_reader.h"

namespace chiron::catalogue {

core::Result<Catalogue> Catalogue::load(const std::string& directory,
                                        const std::vector<std::string>& languages) {
    ContentReader reader(QString::fromStdString(directory), languages);
    auto exercises = reader.exercises();
    CHIRON_TRY(exercises);
    Catalogue catalogue;
    catalogue.m_directory = directory;
    catalogue.m_exercises = std::move(*exercises);
    catalogue.m_objects = reader.named().objects();
    catalogue.m_meshes = reader.named().meshes();
    catalogue.m_tissues = reader.named().tissues();
    catalogue.m_missingTexts = reader.missing();
    return catalogue;
}

const Exercise* Catalogue::find(std::string_view exercise) const {
    for (const Exercise& candidate : m_exercises)
        if (candidate.id == exercise)
            return &candidate;
    return nullptr;
}

const ExerciseLevel* Catalogue::find(std::string_view exercise, int level) const {
    const Exercise* found = find(exercise);
    if (found == nullptr || level < 1 || static_cast<std::size_t>(level) > found->levels.size())
        return nullptr;
    return &found->levels[static_cast<std::size_t>(level) - 1];
}

const ContentObject* Catalogue::findObject(std::string_view id) const {
    for (const ContentObject& object : m_objects)
        if (object.id == id)
            return &object;
    return nullptr;
}

const ContentMesh* Catalogue::findMesh(std::string_view id) const {
    for (const ContentMesh& mesh : m_meshes)
        if (mesh.id == id)
            return &mesh;
    return nullptr;
}

const ContentTissue* Catalogue::findTissue(std::string_view id) const {
    for (const ContentTissue& tissue : m_tissues)
        if (tissue.id == id)
            return &tissue;
    return nullptr;
}

const std::string& textIn(const Translated& text, const std::string& language) {
    static const std::string kNone;
    if (const auto it = text.find(language); it != text.end())
        return it->second;
    const auto english = text.find("en");
    return english != text.end() ? english->second : kNone;
}

} // namespace chiron::catalogue
