// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/settings/settings_screen.h"

#include "desktop/frame/app_context.h"
#include "desktop/frame/interface_language.h"
#include "desktop/settings/site_box.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QRadioButton>

namespace chiron::desktop {

namespace {

struct Choice {
    QString id;
    QString text;
};

/// A card with one radio button per choice; `chosen` receives the id of the selected one.
template <class Chosen>
QWidget* choices(const Theme& theme, QWidget* owner, const QString& name, const QString& title,
                 const std::vector<Choice>& list, const QString& present, Chosen chosen) {
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, title, TextStyle::title));
    auto* group = new QButtonGroup(owner);
    for (const Choice& choice : list) {
        auto* radio = new QRadioButton(choice.text);
        radio->setObjectName(QStringLiteral("settings.%1.%2").arg(name, choice.id));
        radio->setChecked(choice.id == present);
        group->addButton(radio);
        box.layout->addWidget(radio);
        QObject::connect(
            radio, &QRadioButton::clicked, owner, [chosen, id = choice.id] { chosen(id); },
            Qt::QueuedConnection);
    }
    return box.frame;
}

} // namespace

SettingsScreen::SettingsScreen(AppContext& context, const Place& place) : Screen(context, place) {
    auto* page = new ScrollPage(context.theme(), 720);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(page);
    page->column()->addWidget(kit::label(context.theme(), title(), TextStyle::heading));
    page->column()->addWidget(languageBox());
    page->column()->addWidget(themeBox());
    page->column()->addWidget(scaleBox());
    page->column()->addWidget(soundBox());
    if (context.has(database::Role::admin))
        page->column()->addWidget(new SiteBox(context));
    page->column()->addStretch();
}

QString SettingsScreen::title() const {
    return tr("Settings");
}

QString SettingsScreen::help() const {
    return tr("How the program looks and sounds on this station.\n\nEvery choice takes effect at once and is "
              "remembered on this "
              "computer. Nothing here changes what is recorded or how it is scored.\n\nAdministrators also "
              "give the site its name here.");
}

QWidget* SettingsScreen::languageBox() {
    // Each language is named in that language, so that people who cannot read the current one find theirs.
    std::vector<Choice> list;
    for (const auto& [id, name] : languageChoices())
        list.push_back({id, name});
    return choices(context().theme(), this, QStringLiteral("language"), tr("Language"), list,
                   context().language(), [this](const QString& id) { context().setStationLanguage(id); });
}

QWidget* SettingsScreen::themeBox() {
    const std::vector<Choice> list{{QStringLiteral("0"), tr("Light")},
                                   {QStringLiteral("1"), tr("Dark")},
                                   {QStringLiteral("2"), tr("High contrast")}};
    return choices(context().theme(), this, QStringLiteral("theme"), tr("Colours"), list,
                   QString::number(static_cast<int>(context().settings().theme())),
                   [this](const QString& id) {
                       context().settings().setTheme(static_cast<ThemeName>(id.toInt()));
                       context().applyAppearance();
                   });
}

QWidget* SettingsScreen::scaleBox() {
    std::vector<Choice> list;
    for (const int percent : {100, 125, 150, 175, 200})
        list.push_back({QString::number(percent), tr("%1 %").arg(context().locale().toString(percent))});
    return choices(context().theme(), this, QStringLiteral("scale"), tr("Size of text and controls"), list,
                   QString::number(qRound(context().settings().scale() * 100)), [this](const QString& id) {
                       context().settings().setScale(id.toInt() / 100.0);
                       context().applyAppearance();
                   });
}

QWidget* SettingsScreen::soundBox() {
    const kit::Box box = kit::box(context().theme());
    box.layout->addWidget(kit::label(context().theme(), tr("Sound"), TextStyle::title));
    auto* check = new QCheckBox(tr("Play sounds while training"));
    check->setObjectName(QStringLiteral("settings.sound"));
    check->setChecked(context().settings().sound());
    box.layout->addWidget(check);
    const std::vector<Choice> cues{{QStringLiteral("contact"), tr("A click when contact begins")},
                                   {QStringLiteral("force"), tr("A tone that rises with force")},
                                   {QStringLiteral("lean"), tr("A brighter tone the more the force leans")},
                                   {QStringLiteral("warning"), tr("A warning over the limit")}};
    for (const Choice& cue : cues) {
        auto* one = new QCheckBox(cue.text);
        one->setObjectName(QStringLiteral("settings.sound.%1").arg(cue.id));
        one->setChecked(context().settings().soundCue(cue.id));
        one->setEnabled(check->isChecked());
        connect(one, &QCheckBox::toggled, this,
                [this, id = cue.id](bool on) { context().settings().setSoundCue(id, on); });
        connect(check, &QCheckBox::toggled, one, &QCheckBox::setEnabled);
        box.layout->addWidget(one);
    }
    connect(check, &QCheckBox::toggled, this, [this](bool on) { context().settings().setSound(on); });
    box.layout->addWidget(
        kit::label(context().theme(),
                   tr("Everything that can be heard is also shown. The force behind it is recorded "
                      "even when the sound is off."),
                   TextStyle::small, "muted"));
    return box.frame;
}

} // namespace chiron::desktop
