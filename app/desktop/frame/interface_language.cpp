// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/interface_language.h"

#include "core/languages.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

/// The catalogues are part of a static library, and the linker leaves out its resources unless they are
/// requested.
static void initialiseCatalogues() {
    Q_INIT_RESOURCE(i18n);
}

namespace chiron::desktop {

void installLanguage(QCoreApplication& application, const QString& language) {
    initialiseCatalogues();
    for (QTranslator* old : application.findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly)) {
        QCoreApplication::removeTranslator(old);
        delete old;
    }
    QStringList files{QStringLiteral(":/i18n/chiron_%1.qm").arg(language)};
    if (language != QLatin1String("en")) // Qt's own texts are already English
        files.prepend(QLibraryInfo::path(QLibraryInfo::TranslationsPath) +
                      QStringLiteral("/qtbase_%1.qm").arg(language));
    for (const QString& file : files) { // the one installed last takes precedence: Chiron's
        auto* translator = new QTranslator(&application);
        if (translator->load(file))
            QCoreApplication::installTranslator(translator);
        else
            delete translator;
    }
}

QString languageName(const QString& language) {
    for (const auto& [id, name] : languageChoices())
        if (id == language)
            return name;
    return QLocale(language).nativeLanguageName();
}

std::vector<std::pair<QString, QString>> languageChoices() {
    std::vector<std::pair<QString, QString>> choices;
    for (const core::Language& language : core::kLanguages)
        choices.emplace_back(
            QString::fromUtf8(language.id.data(), static_cast<qsizetype>(language.id.size())),
            QString::fromUtf8(language.name.data(), static_cast<qsizetype>(language.name.size())));
    return choices;
}

} // namespace chiron::desktop
