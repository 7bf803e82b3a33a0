// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme_colour.h"

#include <QLocale>
#include <QSettings>
#include <QString>

namespace chiron::desktop {

/// A user's preferences on this station, such as appearance and sound; never recorded data. They are stored
/// in an INI file in the user's configuration folder; an unreadable file gives the defaults.
/// Thread: GUI.
class Settings {
public:
    /// An empty name selects the user's own file.
    explicit Settings(const QString& file = {});

    QString language() const; ///< "en", "de", "el"; the default is the system's language if it is one of them
    void setLanguage(const QString& language);
    static bool isLanguage(const QString& language);
    static QLocale localeOf(const QString& language); ///< for its number and date formats
    ThemeName theme() const;
    void setTheme(ThemeName theme);
    double scale() const; ///< 1..2
    void setScale(double scale);
    bool sound() const;
    void setSound(bool on);
    /// "contact", "force", "lean", "warning": whether the cue is audible while sound is on.
    bool soundCue(const QString& cue) const;
    void setSoundCue(const QString& cue, bool on);
    QString backupFolder() const; ///< empty: beside the database
    void setBackupFolder(const QString& folder);
    /// Of a file dialog (frame/file_folder.h); empty if none was chosen yet.
    QString lastFolder(const QString& purpose) const;
    void setLastFolder(const QString& purpose, const QString& folder);

    /// Small settings of one person on this station (handedness, last device); a key looks like "handedness".
    QVariant ofPerson(qint64 person, const QString& key, const QVariant& otherwise) const;
    void setOfPerson(qint64 person, const QString& key, const QVariant& value);

private:
    mutable QSettings m_file;
};

} // namespace chiron::desktop
