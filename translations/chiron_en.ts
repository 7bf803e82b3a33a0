<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>AccountWords</name>
    <message numerus="yes">
        <source>Try again in %n second(s)</source>
        <translation>
            <numerusform>Try again in %n second</numerusform>
            <numerusform>Try again in %n seconds</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SessionWords</name>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n minute ago</numerusform>
            <numerusform>%n minutes ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n hour ago</numerusform>
            <numerusform>%n hours ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>%n day ago</numerusform>
            <numerusform>%n days ago</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StationWords</name>
    <message numerus="yes">
        <source>The loop is not punctual: %n tick(s) were left out. Close other programs, or permit real-time priority.</source>
        <translation>
            <numerusform>The loop is not punctual: %n tick was left out. Close other programs, or permit real-time priority.</numerusform>
            <numerusform>The loop is not punctual: %n ticks were left out. Close other programs, or permit real-time priority.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StorageWords</name>
    <message numerus="yes">
        <source>%n thing(s) do not hold. Nothing was changed. Keep this database as it is and restore a backup that verifies.</source>
        <translation>
            <numerusform>%n thing does not hold. Nothing was changed. Keep this database as it is and restore a backup that verifies.</numerusform>
            <numerusform>%n things do not hold. Nothing was changed. Keep this database as it is and restore a backup that verifies.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudyReport</name>
    <message numerus="yes">
        <source>SIMULATED: %n participant(s) are programs, not persons</source>
        <translation>
            <numerusform>SIMULATED: %n participant is a program, not a person</numerusform>
            <numerusform>SIMULATED: %n participants are programs, not persons</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n free text(s), in the exported tables</source>
        <translation>
            <numerusform>%n free text, in the exported tables</numerusform>
            <numerusform>%n free texts, in the exported tables</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) have no mark and are left out.</source>
        <translation>
            <numerusform>%n trial has no mark and is left out.</numerusform>
            <numerusform>%n trials have no mark and are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Only %n participant(s): how people differ is hardly known.</source>
        <translation>
            <numerusform>Only %n participant: how people differ is hardly known.</numerusform>
            <numerusform>Only %n participants: how people differ is hardly known.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) lie off the sphere.</source>
        <translation>
            <numerusform>%n mark lies off the sphere.</numerusform>
            <numerusform>%n marks lie off the sphere.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) are of the observer for planning: nothing was rendered.</source>
        <translation>
            <numerusform>%n mark is of the observer for planning: nothing was rendered.</numerusform>
            <numerusform>%n marks are of the observer for planning: nothing was rendered.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) were set without touching anything.</source>
        <translation>
            <numerusform>%n mark was set without touching anything.</numerusform>
            <numerusform>%n marks were set without touching anything.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) who withdrew are left out.</source>
        <translation>
            <numerusform>%n participant who withdrew is left out.</numerusform>
            <numerusform>%n participants who withdrew are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n simulated participant(s) are left out: the group is of people.</source>
        <translation>
            <numerusform>%n simulated participant is left out: the group is of people.</numerusform>
            <numerusform>%n simulated participants are left out: the group is of people.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) could not be used: the difference or the answer is missing.</source>
        <translation>
            <numerusform>%n trial could not be used: the difference or the answer is missing.</numerusform>
            <numerusform>%n trials could not be used: the difference or the answer is missing.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Only %n trial(s): the interval is wide and rests partly on what was assumed beforehand.</source>
        <translation>
            <numerusform>Only %n trial: the interval is wide and rests partly on what was assumed beforehand.</numerusform>
            <numerusform>Only %n trials: the interval is wide and rests partly on what was assumed beforehand.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) are not above zero and are left out.</source>
        <translation>
            <numerusform>%n setting is not above zero and is left out.</numerusform>
            <numerusform>%n settings are not above zero and are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Only %n setting(s): how much they scatter is hardly known.</source>
        <translation>
            <numerusform>Only %n setting: how much they scatter is hardly known.</numerusform>
            <numerusform>Only %n settings: how much they scatter is hardly known.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n answer(s) are not numbers above zero and are left out.</source>
        <translation>
            <numerusform>%n answer is not a number above zero and is left out.</numerusform>
            <numerusform>%n answers are not numbers above zero and are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Only %n answer(s): the result is hardly known.</source>
        <translation>
            <numerusform>Only %n answer: the result is hardly known.</numerusform>
            <numerusform>Only %n answers: the result is hardly known.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Only %n participant(s) with an exponent: how people differ is hardly known.</source>
        <translation>
            <numerusform>Only %n participant with an exponent: how people differ is hardly known.</numerusform>
            <numerusform>Only %n participants with an exponent: how people differ is hardly known.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) are left out: their answers give no value.</source>
        <translation>
            <numerusform>%n participant is left out: their answers give no value.</numerusform>
            <numerusform>%n participants are left out: their answers give no value.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) of the group were simulated without rendering: told the values, nothing was felt.</source>
        <translation>
            <numerusform>%n participant of the group was simulated without rendering: told the values, nothing was felt.</numerusform>
            <numerusform>%n participants of the group were simulated without rendering: told the values, nothing was felt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 simulated run(s) gave no value.</source>
        <translation>
            <numerusform>%n of %1 simulated runs gave no value.</numerusform>
            <numerusform>%n of %1 simulated runs gave no value.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Shown, not felt: %n trial(s) were done on a device that renders no force.</source>
        <translation>
            <numerusform>Shown, not felt: %n trial was done on a device that renders no force.</numerusform>
            <numerusform>Shown, not felt: %n trials were done on a device that renders no force.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) are left out of the group: objects were shown to them, not felt.</source>
        <translation>
            <numerusform>%n participant is left out of the group: objects were shown to them, not felt.</numerusform>
            <numerusform>%n participants are left out of the group: objects were shown to them, not felt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The group holds %n participant(s) to whom objects were shown, not felt.</source>
        <translation>
            <numerusform>The group holds %n participant to whom objects were shown, not felt.</numerusform>
            <numerusform>The group holds %n participants to whom objects were shown, not felt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message numerus="yes">
        <source>%n pass mark(s) of this level were not met:</source>
        <translation>
            <numerusform>%n pass mark of this level was not met:</numerusform>
            <numerusform>%n pass marks of this level were not met:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The computer could not keep up and %n sample(s) were lost. The rest is kept and can be played back. It does not count towards passing; close other programs before the next attempt.</source>
        <translation>
            <numerusform>The computer could not keep up and %n sample was lost. The rest is kept and can be played back. It does not count towards passing; close other programs before the next attempt.</numerusform>
            <numerusform>The computer could not keep up and %n samples were lost. The rest is kept and can be played back. It does not count towards passing; close other programs before the next attempt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ApexPage</name>
    <message numerus="yes">
        <source>Per cent of the sphere&apos;s radius. %n mark(s)</source>
        <translation>
            <numerusform>Per cent of the sphere&apos;s radius. %n mark</numerusform>
            <numerusform>Per cent of the sphere&apos;s radius. %n marks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n trial(s) repeated</source>
        <translation>
            <numerusform>, %n trial repeated</numerusform>
            <numerusform>, %n trials repeated</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::DeviceChooser</name>
    <message numerus="yes">
        <source>Ready: %n rows, %1 s.</source>
        <translation>
            <numerusform>Ready: %n row, %1 s.</numerusform>
            <numerusform>Ready: %n rows, %1 s.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExerciseCard</name>
    <message numerus="yes">
        <source>%n attempt(s), not passed yet</source>
        <translation>
            <numerusform>%n attempt, not passed yet</numerusform>
            <numerusform>%n attempts, not passed yet</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExperimenterPanel</name>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n trial</numerusform>
            <numerusform>%n trials</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The device cannot render all differences: %n are left.</source>
        <translation>
            <numerusform>The device cannot render all differences: %n is left.</numerusform>
            <numerusform>The device cannot render all differences: %n are left.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FreezeDialog</name>
    <message numerus="yes">
        <source>%n condition(s)</source>
        <translation>
            <numerusform>%n condition</numerusform>
            <numerusform>%n conditions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) planned</source>
        <translation>
            <numerusform>%n participant planned</numerusform>
            <numerusform>%n participants planned</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::GroupPage</name>
    <message numerus="yes">
        <source>Weber fraction of %n participant(s), as random effects</source>
        <translation>
            <numerusform>Weber fraction of %n participant, as a random effect</numerusform>
            <numerusform>Weber fraction of %n participants, as random effects</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::HomeScreen</name>
    <message numerus="yes">
        <source>%n session(s) in the last 7 days</source>
        <translation>
            <numerusform>%n session in the last 7 days</numerusform>
            <numerusform>%n sessions in the last 7 days</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n account(s) can log in.</source>
        <translation>
            <numerusform>%n account can log in.</numerusform>
            <numerusform>%n accounts can log in.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The program ended unexpectedly during session %1 (%2, %3). It was brought in as interrupted: %n sample(s) are kept and can be played back. It does not count.</source>
        <translation>
            <numerusform>The program ended unexpectedly during session %1 (%2, %3). It was brought in as interrupted: %n sample is kept and can be played back. It does not count.</numerusform>
            <numerusform>The program ended unexpectedly during session %1 (%2, %3). It was brought in as interrupted: %n samples are kept and can be played back. It does not count.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::InfoPanel</name>
    <message numerus="yes">
        <source>%n samples could not be recorded: this session will be incomplete.</source>
        <translation>
            <numerusform>%n sample could not be recorded: this session will be incomplete.</numerusform>
            <numerusform>%n samples could not be recorded: this session will be incomplete.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Recording complete; %n ticks late</source>
        <translation>
            <numerusform>Recording complete; %n tick late</numerusform>
            <numerusform>Recording complete; %n ticks late</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LevelChooser</name>
    <message numerus="yes">
        <source>Tried %n times, not passed yet</source>
        <translation>
            <numerusform>Tried %n time, not passed yet</numerusform>
            <numerusform>Tried %n times, not passed yet</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PersonPage</name>
    <message numerus="yes">
        <source>Run again from its log, the procedure makes the same %n choice(s).</source>
        <translation>
            <numerusform>Run again from its log, the procedure makes the same %n choice.</numerusform>
            <numerusform>Run again from its log, the procedure makes the same %n choices.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PreviewPage</name>
    <message numerus="yes">
        <source>middle of %n run(s)</source>
        <translation>
            <numerusform>%n run</numerusform>
            <numerusform>middle of %n runs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnaireSummary</name>
    <message numerus="yes">
        <source>Answered by %n participant(s)</source>
        <translation>
            <numerusform>Answered by %n participant</numerusform>
            <numerusform>Answered by %n participants</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RankingBox</name>
    <message numerus="yes">
        <source>%n ranking(s) of three objects; each is one judgement.</source>
        <translation>
            <numerusform>%n ranking of three objects; each is one judgement.</numerusform>
            <numerusform>%n rankings of three objects; each is one judgement.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s); each one&apos;s mean ranks are one judgement.</source>
        <translation>
            <numerusform>%n participant; their mean ranks are one judgement.</numerusform>
            <numerusform>%n participants; each one&apos;s mean ranks are one judgement.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In %n ranking(s) something was called equal.</source>
        <translation>
            <numerusform>In %n ranking something was called equal.</numerusform>
            <numerusform>In %n rankings something was called equal.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RosterDialog</name>
    <message numerus="yes">
        <source>%n people would be added. Each must choose a password of their own at the first login.</source>
        <translation>
            <numerusform>%n person would be added. They must choose a password of their own at the first login.</numerusform>
            <numerusform>%n people would be added. Each must choose a password of their own at the first login.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %n people</source>
        <translation>
            <numerusform>Import %n person</numerusform>
            <numerusform>Import %n people</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people were added.</source>
        <translation>
            <numerusform>%n person was added.</numerusform>
            <numerusform>%n people were added.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Adding %n people …</source>
        <translation>
            <numerusform>Adding %n person …</numerusform>
            <numerusform>Adding %n people …</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionsScreen</name>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n session</numerusform>
            <numerusform>%n sessions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) in all.</source>
        <translation>
            <numerusform>%n session in all.</numerusform>
            <numerusform>%n sessions in all.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StorageScreen</name>
    <message numerus="yes">
        <source>%1 of %n session(s)</source>
        <translation>
            <numerusform>%1 of %n session</numerusform>
            <numerusform>%1 of %n sessions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StudiesScreen</name>
    <message numerus="yes">
        <source>%n stud(y/ies)</source>
        <translation>
            <numerusform>%n study</numerusform>
            <numerusform>%n studies</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StudyDataScreen</name>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>%n participant</numerusform>
            <numerusform>%n participants</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n scored trial(s)</source>
        <translation>
            <numerusform>%n scored trial</numerusform>
            <numerusform>%n scored trials</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StudyScreen</name>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… and %n more</numerusform>
            <numerusform>… and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrialsScreen</name>
    <message numerus="yes">
        <source>Rest your hand. It can go on in %n second(s).</source>
        <translation>
            <numerusform>Rest your hand. It can go on in %n second.</numerusform>
            <numerusform>Rest your hand. It can go on in %n seconds.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::UnblindDialog</name>
    <message numerus="yes">
        <source>%n participant(s) are still to come. Whoever conducts their runs will no longer be blind.</source>
        <translation>
            <numerusform>%n participant is still to come. Whoever conducts their runs will no longer be blind.</numerusform>
            <numerusform>%n participants are still to come. Whoever conducts their runs will no longer be blind.</numerusform>
        </translation>
    </message>
</context>
</TS>
