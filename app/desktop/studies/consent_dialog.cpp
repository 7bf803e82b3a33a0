// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/consent_dialog.h"

#include "desktop/frame/interface_language.h"
#include "desktop/studies/participant_sentences.h"
#include "desktop/studies/study_device.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLocale>
#include <algorithm>

namespace chiron::desktop {

ConsentDialog::ConsentDialog(AppContext& context, const OpenStudy& study,
                             const database::Participant& participant, QWidget* parent)
    : FormDialog(context, QStringLiteral("consent"),
                 tr("Consent of %1").arg(QString::fromStdString(participant.code)), parent),
      m_design(study.design), m_texts(study.design.consent), m_told(shownInstructions(study.design)),
      m_participant(participant) {
    m_language = new QComboBox;
    m_language->setObjectName(QStringLiteral("consent.language"));
    m_language->setAccessibleName(tr("Language"));
    for (const auto& [language, words] : m_texts)
        if (!words.empty())
            m_language->addItem(languageName(QString::fromStdString(language)),
                                QString::fromStdString(language));
    m_language->setCurrentIndex(std::max(0, m_language->findData(context.language())));
    m_language->setVisible(m_language->count() > 1);
    column()->addWidget(m_language, 0, Qt::AlignLeft);
    const kit::Box read = kit::box(theme()); // people who agree declare that they have read it
    read.layout->addWidget(kit::label(theme(), tr("Instructions"), TextStyle::title));
    m_instructions = kit::label(theme(), {}, TextStyle::body);
    m_instructions->setObjectName(QStringLiteral("consent.instructions"));
    read.layout->addWidget(m_instructions);
    m_force = kit::label(theme(), {}, TextStyle::body);
    m_force->setObjectName(QStringLiteral("consent.force"));
    read.layout->addWidget(m_force);
    column()->addWidget(read.frame);
    const kit::Box box = kit::box(theme());
    m_text = kit::label(theme(), {}, TextStyle::body);
    m_text->setObjectName(QStringLiteral("consent.text"));
    box.layout->addWidget(m_text);
    column()->addWidget(box.frame);
    m_agreed = new QCheckBox(tr("I have read this and I agree"));
    m_agreed->setObjectName(QStringLiteral("consent.agreed"));
    m_agreed->setFont(theme().font(TextStyle::body));
    column()->addWidget(m_agreed);
    column()->addWidget(kit::label(theme(),
                                   tr("The time is recorded, and a checksum (SHA-256) that shows which text "
                                      "you have read. You may withdraw at any time."),
                                   TextStyle::small, "muted"));
    setAccept(tr("Record the consent"));
    connect(m_language, &QComboBox::activated, this, &ConsentDialog::showText);
    const auto weigh = [this] {
        setAcceptable(m_agreed->isChecked(), tr("Once the participant agrees, tick the box first."));
    };
    connect(m_agreed, &QCheckBox::toggled, this, weigh);
    weigh();
    showText();
    m_agreed->setFocus();
    if (parent)
        resize(parent->window()->size()); // full size, because the window behind it names conditions
}

void ConsentDialog::showText() {
    m_instructions->setText(study_words::text(m_told, m_language->currentData().toString()));
    m_force->setText(
        forceSentences(m_design, studyDevice(), m_language->currentData().toString()).join(QLatin1Char(' ')));
    const auto found = m_texts.find(m_language->currentData().toString().toStdString());
    m_text->setText(found == m_texts.end() ? tr("This study has no consent text.")
                                           : QString::fromStdString(found->second));
    m_agreed->setChecked(false); // it belonged to another text
}

void ConsentDialog::submit() {
    setWorking(true);
    const std::string sha = catalogue::studySha256(m_text->text().toUtf8());
    writeStudies(
        context(), this,
        [participant = m_participant.id, sha](database::StudyRepository& studies) {
            return studies.recordConsent(participant, sha);
        },
        [this](const core::Result<void>& done) {
            setWorking(false);
            if (!done) {
                say("bad", tr("The consent was not recorded.\n%1").arg(inWords(done.error())));
                return;
            }
            context().messages().done(
                tr("The consent of %1 was recorded.").arg(QString::fromStdString(m_participant.code)));
            emit changed();
            accept();
        });
}

} // namespace chiron::desktop
