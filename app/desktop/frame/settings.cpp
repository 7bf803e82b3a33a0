// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/settings.h"

#include "core/languages.h"

#include <QDir>
#include <QStandardPaths>
#include <algorithm>

namespace chiron::desktop {

namespace {

const QStringList kThemes{QStringLiteral("light"), QStringLiteral("dark"), QStringLiteral("high_contrast")};

QLatin1String asText(std::string_view token) {
    return {token.data(), static_cast<qsizetype>(token.size())};
}

QString settingsFile(const QString& given) {
    if (!given.isEmpty())
        return given;
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation))
        .filePath(QStringLiteral("chiron/desktop.ini"));
}

/// The entry of a language, or English if it is unknown.
const core::Language& languageOf(const QString& id) {
    const auto found =
        std::find_if(core::kLanguages.begin(), core::kLanguages.end(),
                     [&](const core::Language& language) { return id == asText(language.id); });
    return found == core::kLanguages.end() ? core::kLanguages.front() : *found;
}

QString personKey(qint64 person, const QString& key) {
    return QStringLiteral("person_%1/%2").arg(person).arg(key);
}

} // namespace

Settings::Settings(const QString& file) : m_file(settingsFile(file), QSettings::IniFormat) {}

QString Settings::language() const {
    const QString stored = m_file.value(QStringLiteral("language")).toString();
    if (isLanguage(stored))
        return stored;
    return asText(languageOf(QLocale::system().name().section(QLatin1Char('_'), 0, 0)).id);
}

void Settings::setLanguage(const QString& language) {
    m_file.setValue(QStringLiteral("language"), language);
}

bool Settings::isLanguage(const QString& language) {
    return language == asText(languageOf(language).id);
}

QLocale Settings::localeOf(const QString& language) {
    return QLocale(asText(languageOf(language).locale));
}

ThemeName Settings::theme() const {
    const qsizetype index = kThemes.indexOf(m_file.value(QStringLiteral("theme")).toString());
    return index < 0 ? ThemeName::light : static_cast<ThemeName>(index);
}

void Settings::setTheme(ThemeName theme) {
    m_file.setValue(QStringLiteral("theme"), kThemes.at(static_cast<int>(theme)));
}

double Settings::scale() const {
    bool isNumber = false;
    const double scale = m_file.value(QStringLiteral("scale"), 1.0).toDouble(&isNumber);
    return isNumber ? qBound(1.0, scale, 2.0) : 1.0;
}

void Settings::setScale(double scale) {
    m_file.setValue(QStringLiteral("scale"), qBound(1.0, scale, 2.0));
}

bool Settings::sound() const {
    return m_file.value(QStringLiteral("sound"), true).toBool();
}

void Settings::setSound(bool on) {
    m_file.setValue(QStringLiteral("sound"), on);
}

bool Settings::soundCue(const QString& cue) const {
    return m_file.value(QStringLiteral("sound_cues/") + cue, true).toBool();
}

void Settings::setSoundCue(const QString& cue, bool on) {
    m_file.setValue(QStringLiteral("sound_cues/") + cue, on);
}

QString Settings::backupFolder() const {
    return m_file.value(QStringLiteral("backup_folder")).toString();
}

void Settings::setBackupFolder(const QString& folder) {
    m_file.setValue(QStringLiteral("backup_folder"), folder);
}

QString Settings::lastFolder(const QString& purpose) const {
    return m_file.value(QStringLiteral("last_folders/") + purpose).toString();
}

void Settings::setLastFolder(const QString& purpose, const QString& folder) {
    m_file.setValue(QStringLiteral("last_folders/") + purpose, folder);
}

QVariant Settings::ofPerson(qint64 person, const QString& key, const QVariant& otherwise) const {
    return m_file.value(personKey(person, key), otherwise);
}

void Settings::setOfPerson(qint64 person, const QString& key, const QVariant& value) {
    m_file.setValue(personKey(person, key), value);
}

} // namespace chiron::desktop
