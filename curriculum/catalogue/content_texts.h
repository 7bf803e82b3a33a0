// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/json_file.h"
#include "catalogue/schema.h"
#include "core/languages.h"
#include "core/result.h"

#include <QJsonObject>
#include <QStringList>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace chiron::catalogue {

/// A text that a language lacks. English is shown in its place.
struct MissingText {
    std::string language;
    std::string file; ///< of the content, which has the text in English
    std::string path; ///< JSON path in it

    bool operator==(const MissingText&) const = default;
};

/// The translations of one folder of content: `texts/<language>.json` beside the files that have the texts in English.
///
/// A language's file has the keys of the content: an object's text stands under the same key, that of an element of a list under the element's id
/// (metric, mark), and a list of texts is a list again. Content files may also have a text in all languages themselves, `{"en": ..., "de": ...}`:
/// that is how they were written before there were files of languages.
///
/// Read the folder, lay() the translations over each of its documents, and finish(): what is wrong with the language files is told there, with
/// file and place.
class ContentTexts {
public:
    ContentTexts() = default;

    /// `languages` of the content, English first. A folder without texts/ has no translations. Failure (badInput, notFound): a file of a language
    /// that is not on the list, or of English, whose place is the content; not JSON.
    static core::Result<ContentTexts> read(const QString& folder, const std::vector<std::string>& languages);

    /// Content's schema of this name, for laid(): it says which keys are texts. None where the folder has no translations, so that nothing is to be
    /// laid over its documents. Failure: as readSchema().
    core::Result<std::optional<Schema>> schemaOfTexts(const QString& contentDirectory, const QString& name) const;

    /// `document`, a part of the content file `file` at `path` in it, with each of its texts as an object by language. Its translations stand in
    /// the language files below the keys `place`: {"levels", "bend"}. What is wrong with the document itself goes to `problems`.
    QJsonObject laid(const QJsonObject& document, const Schema& schema, const QStringList& place, const QString& file, const QString& path,
                     Problems& problems);

    /// Failure (badInput): every text that is for nothing, is given twice, or is no text, and every entry below which nothing was laid.
    core::Result<void> finish();

    const std::vector<MissingText>& missing() const { return m_missing; }
    /// SHA-256 of the texts in each language that has any, lower-case hex. Says nothing of the form they were written in.
    std::map<std::string, std::string> digests() const;

private:
    /// The translations into one language, and what is wrong with them.
    struct File {
        std::string language;
        JsonFile json;
        Problems problems;
    };
    /// A place in a content file.
    struct At {
        QString file;
        QString path;
    };

    QJsonValue laidOver(const QJsonValue& value, const Schema& schema, const QJsonValue& given, const QString& path, File& file) const;
    QJsonValue elementsLaidOver(const QJsonArray& array, const Schema& schema, const QJsonValue& given, const QString& path, File& file) const;
    void note(const QJsonValue& value, const Schema& schema, const At& at, const QString& place, Problems& problems);
    void refuseUnclaimed(const QJsonObject& entries, const QString& above, const QString& path, Problems& problems) const;

    std::vector<std::string> m_languages = core::languageIds();
    std::vector<File> m_files;
    std::set<QString> m_claimed; ///< places below which something was laid: "levels/bend"
    std::vector<MissingText> m_missing;
    std::map<std::string, QJsonObject> m_texts; ///< by language: place and path → text
};

} // namespace chiron::catalogue
