// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/settings/site_box.h"

#include "database/repositories/site_repository.h"
#include "database/write_context.h"
#include "desktop/accounts/form.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/frame/app_context.h"
#include "desktop/site/site_name.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>
#include <QPushButton>

namespace chiron::desktop {

SiteBox::SiteBox(AppContext& context, QWidget* parent) : QWidget(parent), m_context(context) {
    const Theme& theme = context.theme();
    const kit::Box box = kit::box(theme);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(box.frame);
    box.layout->addWidget(kit::label(theme, tr("Site"), TextStyle::title));
    m_name =
        form::textField(theme, box.layout, tr("Name of the site, such as the clinic's (may be left empty)"),
                        QStringLiteral("settings.site_name"));
    m_name->setMaxLength(database::kMaximumSiteNameCharacters);
    box.layout->addWidget(
        kit::label(theme,
                   tr("Everybody sees it at the login, on password slips and at the top of reports. "
                      "Each change is recorded in the audit trail."),
                   TextStyle::small, "muted"));
    m_save = kit::button(theme, tr("Save the site's name"), "primary");
    m_save->setObjectName(QStringLiteral("settings.save_site_name"));
    box.layout->addWidget(m_save, 0, Qt::AlignLeft);
    m_notice = new NoticeArea(theme, NoticeArea::Room::none); // it is the last box of the page
    m_notice->setObjectName(QStringLiteral("settings.site_notice"));
    box.layout->addWidget(m_notice);
    connect(m_name, &QLineEdit::textChanged, this, &SiteBox::renew);
    connect(m_name, &QLineEdit::returnPressed, this, &SiteBox::save);
    connect(m_save, &QPushButton::clicked, this, &SiteBox::save);
    renew();
    load();
}

void SiteBox::load() {
    m_context.background().run(
        this,
        [&database = m_context.site().database(), actor = m_context.actor()](WorkToken&) {
            return readSiteName(database, actor);
        },
        [this](const core::Result<QString>& name) {
            if (!name) {
                m_notice->say(
                    "bad",
                    tr("The site's name could not be read.\n%1").arg(inWords(name.error(), Tried::reading)));
                return;
            }
            m_known = true;
            m_stored = *name;
            m_name->setText(*name);
            renew();
        });
}

void SiteBox::renew() {
    m_name->setEnabled(m_known && !m_saves);
    m_save->setEnabled(m_known && !m_saves && m_name->text().trimmed() != m_stored);
}

void SiteBox::save() {
    if (!m_save->isEnabled())
        return;
    m_saves = true;
    renew();
    const QString name = m_name->text().trimmed();
    m_context.background().run(
        this,
        [&database = m_context.site().database(), actor = m_context.actor(),
         name = name.toStdString()](WorkToken&) {
            return database.write([&](database::WriteContext& writing) {
                return database::SiteRepository(writing.connection(), actor).setSiteName(name);
            });
        },
        [this, name](const core::Result<void>& done) {
            m_saves = false;
            m_stored = done ? name : m_stored;
            renew();
            m_name->setFocus();
            if (done)
                m_notice->say("good", name.isEmpty() ? tr("The site has no name any more.")
                                                     : tr("The site is now called %1.").arg(name));
            else
                m_notice->say("bad", tr("The site's name was not changed.\n%1").arg(inWords(done.error())));
        });
}

} // namespace chiron::desktop
