// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sound/sound_loader.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QLibrary>

namespace chiron::desktop {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(SoundLoader)
};

LoadedSound silent(const QString& why) {
    return {nullptr, why};
}

} // namespace

LoadedSound loadSound() {
    if (qEnvironmentVariableIsSet("CHIRON_NO_SOUND"))
        return silent(
            Words::tr("Sound is switched off on this station. Everything that can be heard is also shown."));
    const QString named = qEnvironmentVariable("CHIRON_PLUGINS");
    const QDir folder(named.isEmpty() ? QCoreApplication::applicationDirPath() : named);
    QLibrary library(folder.filePath(QLatin1String(kSoundPluginFile)));
    // Its threads may still be running when the program ends.
    library.setLoadHints(QLibrary::PreventUnloadHint);
    if (!QFile::exists(library.fileName()) || !library.load())
        return silent(Words::tr(
            "The sound module of Chiron is not installed. Everything that can be heard is also shown."));
    const auto abi = reinterpret_cast<SoundAbiFunction>(library.resolve(kSoundAbiSymbol));
    const auto make = reinterpret_cast<SoundMakeFunction>(library.resolve(kSoundMakeSymbol));
    if (!abi || !make || soundAbi() != abi())
        return silent(Words::tr("The sound module belongs to another version of Chiron. Everything that can "
                                "be heard is also shown."));
    std::unique_ptr<ISoundOutput> output(make());
    if (!output)
        return silent(
            Words::tr("This station has no sound output. Everything that can be heard is also shown."));
    return {std::move(output), {}};
}

} // namespace chiron::desktop
