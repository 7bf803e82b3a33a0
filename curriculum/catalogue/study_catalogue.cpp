// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_catalogue.h"

#include "catalogue/whole_file.h"
#include "catalogue/catalogue.h"
#include "catalogue/study_reader.h"

#include <QDir>
#include <QFile>
#include <algorithm>

namespace chiron::catalogue {

core::Result<StudyCatalogue> StudyCatalogue::load(const std::string& contentDirectory) {
    const auto directory = contentDirectory.empty() ? findContentDirectory() : core::Result<std::string>(contentDirectory);
    if (!directory)
        return tl::unexpected(directory.error());
    const QDir folder(QString::fromStdString(*directory) + "/studies");
    StudyCatalogue out;
    std::string faults;
    for (const QString& name : folder.entryList({"*.json"}, QDir::Files, QDir::Name)) {
        constexpr qint64 kLargest_bytes = 1 << 20;
        const QString path = folder.filePath(name);
        const auto text = readWholeFile(path, kLargest_bytes);
        if (!text)
            return tl::unexpected(text.error());
        auto study = readStudy(*text, path.toStdString());
        if (study && name != QString::fromStdString(study->id) + ".json")
            study = core::fail(core::ErrorCode::badInput, path.toStdString() + ": $.id: \"" + study->id +
                                                              "\": expected the name of its file");
        if (study)
            out.m_studies.push_back(*std::move(study));
        else
            faults += (faults.empty() ? "" : "\n") + study.error().message;
    }
    if (!faults.empty())
        return core::fail(core::ErrorCode::badInput, faults);
    return out;
}

const psychophysics::StudyDesign* StudyCatalogue::find(std::string_view id) const noexcept {
    const auto found = std::find_if(m_studies.begin(), m_studies.end(), [&](const auto& study) { return study.id == id; });
    return found == m_studies.end() ? nullptr : &*found;
}

} // namespace chiron::catalogue
