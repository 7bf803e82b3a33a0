// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme_colour.h"

#include <QLocale>
#include <QSettings>
#include <QString>

namespace chiron::desktop {

/// What this station remembers of how somebody likes the program: how it looks and sounds, never what was recorded. An INI
/// file in the user's configuration folder; a broken one gives the defaults. GUI thread.
class Settings {
public:
    /// Empty: the user's own file.
    explicit Settings(const QString& file = {});

    QString language() const; ///< "en", "de", "el"; the system's where it is one of them
    void setLanguage(const QString& language);
    static bool isLanguage(const QString& language);
    static QLocale localeOf(const QString& language); ///< its numbers and dates
    ThemeName theme() const;
    void setTheme(ThemeName theme);
    double scale() const; ///< 1..2
    void setScale(double scale);
    bool sound() const;
    void setSound(bool on);
    bool soundCue(const QString& cue) const; ///< "contact", "force", "lean", "warning": heard where sound is on
    void setSoundCue(const QString& cue, bool on);
    QString backupFolder() const; ///< empty: beside the database
    void setBackupFolder(const QString& folder);
    QString lastFolder(const QString& purpose) const; ///< of a file dialog (frame/file_folder.h); empty: none was chosen yet
    void setLastFolder(const QString& purpose, const QString& folder);

    /// Small things that belong to one person here (handedness, last device): key as "handedness".
    QVariant ofPerson(qint64 person, const QString& key, const QVariant& otherwise) const;
    void setOfPerson(qint64 person, const QString& key, const QVariant& value);

private:
    mutable QSettings m_file;
};

} // namespace chiron::desktop
