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

/// A text that a language lacks, so that English is shown in its place.
struct MissingText {
    std::string language;
    std::string file; ///< content file that has the text in English
    std::string path; ///< JSON path in that file

    bool operator==(const MissingText&) const = default;
};

/// The translations of one folder of content: `texts/<language>.json` beside the files that hold the texts in
/// English.
///
/// A language file has the same keys as the content. The text of an object stands under the same key; the
/// text of an element of a list stands under the element's id (metric, mark); a list of texts is again a
/// list. A content file may also hold a text in all languages itself, `{"en": ..., "de": ...}`, which is how
/// texts were written before there were language files.
///
/// Call read() for the folder, laid() for each of its documents, and then finish(), which reports what is
/// wrong with the language files, with file and place.
class ContentTexts {
public:
    ContentTexts() = default;

    /// Reads the language files of `folder`. `languages` lists the languages of the content, English first. A
    /// folder without texts/ has no translations.
    /// Errors: badInput or notFound: a file of a language that is not on the list; a file for English, whose
    /// texts belong in the content itself; not JSON.
    static core::Result<ContentTexts> read(const QString& folder, const std::vector<std::string>& languages);

    /// Returns the content's schema of this name, for use with laid(): it says which keys are texts. Returns
    /// none if the folder has no translations, because then there is nothing to lay over its documents.
    /// Errors: as readSchema().
    core::Result<std::optional<Schema>> schemaOfTexts(const QString& contentDirectory,
                                                      const QString& name) const;

    /// Returns `document`, which is the part of the content file `file` at `path`, with each of its texts
    /// turned into an object by language. Its translations stand in the language files below the keys
    /// `place`, for example {"levels", "bend"}. Faults of the document itself are added to `problems`.
    QJsonObject laid(const QJsonObject& document, const Schema& schema, const QStringList& place,
                     const QString& file, const QString& path, Problems& problems);

    /// Errors: badInput for every text that belongs to nothing, is given twice or is not a text, and for
    /// every entry below which nothing was laid over a document.
    core::Result<void> finish();

    const std::vector<MissingText>& missing() const { return m_missing; }
    /// Returns the SHA-256 (lower-case hex) of the texts in each language that has any. It does not depend on
    /// the form in which the texts were written.
    std::map<std::string, std::string> digests() const;

private:
    /// The translations into one language, and the faults found in them.
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

    QJsonValue laidOver(const QJsonValue& value, const Schema& schema, const QJsonValue& given,
                        const QString& path, File& file) const;
    QJsonValue elementsLaidOver(const QJsonArray& array, const Schema& schema, const QJsonValue& given,
                                const QString& path, File& file) const;
    void note(const QJsonValue& value, const Schema& schema, const At& at, const QString& place,
              Problems& problems);
    void refuseUnclaimed(const QJsonObject& entries, const QString& above, const QString& path,
                         Problems& problems) const;

    std::vector<std::string> m_languages = core::languageIds();
    std::vector<File> m_files;
    std::set<QString> m_claimed; ///< places below which translations were laid: "levels/bend"
    std::vector<MissingText> m_missing;
    std::map<std::string, QJsonObject> m_texts; ///< by language: place and path → text
};

} // namespace chiron::catalogue
