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
    <name>AnswerNote</name>
    <message numerus="yes">
        <source>%n false alarm(s)</source>
        <translation>
            <numerusform>%n false alarm</numerusform>
            <numerusform>%n false alarms</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FreezeChecks</name>
    <message numerus="yes">
        <source>%n entr(y/ies) must be corrected. The first: %1</source>
        <translation>
            <numerusform>%n entry must be corrected: %1</numerusform>
            <numerusform>%n entries must be corrected. The first: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Tried %n time(s).</source>
        <translation>
            <numerusform>Tried %n time.</numerusform>
            <numerusform>Tried %n times.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) before each condition.</source>
        <translation>
            <numerusform>%n trial before each condition.</numerusform>
            <numerusform>%n trials before each condition.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ParticipantFacts</name>
    <message numerus="yes">
        <source>%1, and %n for practice</source>
        <translation>
            <numerusform>%1, and %n for practice</numerusform>
            <numerusform>%1, and %n for practice</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ParticipantSentences</name>
    <message numerus="yes">
        <source>The study has %n part(s).</source>
        <translation>
            <numerusform>The study has %n part.</numerusform>
            <numerusform>The study has %n parts.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Each part has %n trial(s).</source>
        <translation>
            <numerusform>Each part has %n trial.</numerusform>
            <numerusform>Each part has %n trials.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Each part has at most %n trial(s).</source>
        <translation>
            <numerusform>Each part has at most %n trial.</numerusform>
            <numerusform>Each part has at most %n trials.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There are %n trial(s).</source>
        <translation>
            <numerusform>There is %n trial.</numerusform>
            <numerusform>There are %n trials.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There are at most %n trial(s).</source>
        <translation>
            <numerusform>There is at most %n trial.</numerusform>
            <numerusform>There are at most %n trials.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>After every %n trial(s) there is a break</source>
        <translation>
            <numerusform>After every %n trial there is a break</numerusform>
            <numerusform>After every %n trials there is a break</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Before the trials you answer %n question(s).</source>
        <translation>
            <numerusform>Before the trials you answer %n question.</numerusform>
            <numerusform>Before the trials you answer %n questions.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>After the trials you answer %n question(s).</source>
        <translation>
            <numerusform>After the trials you answer %n question.</numerusform>
            <numerusform>After the trials you answer %n questions.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Each part begins with %n practice trial(s), which do not count.</source>
        <translation>
            <numerusform>Each part begins with %n practice trial, which does not count.</numerusform>
            <numerusform>Each part begins with %n practice trials, which do not count.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>After each part you answer %n question(s) about it.</source>
        <translation>
            <numerusform>After each part you answer %n question about it.</numerusform>
            <numerusform>After each part you answer %n questions about it.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>After the trials you answer %n question(s) about them.</source>
        <translation>
            <numerusform>After the trials you answer %n question about them.</numerusform>
            <numerusform>After the trials you answer %n questions about them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>First come %n practice trial(s), which do not count.</source>
        <translation>
            <numerusform>First comes %n practice trial, which does not count.</numerusform>
            <numerusform>First come %n practice trials, which do not count.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PlanWords</name>
    <message numerus="yes">
        <source>%n of %1 simulated run(s) gave no usable value; such runs are left out of group values.</source>
        <translation>
            <numerusform>%n of %1 simulated runs gave no usable value; such runs are left out of group values.</numerusform>
            <numerusform>%n of %1 simulated runs gave no usable value; such runs are left out of group values.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RosterWords</name>
    <message numerus="yes">
        <source>%n people would be added. Each must choose a password of their own at the first login.</source>
        <translation>
            <numerusform>%n person would be added. They must choose a password of their own at the first login.</numerusform>
            <numerusform>%n people would be added. Each must choose a password of their own at the first login.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people would be updated; their passwords remain valid.</source>
        <translation>
            <numerusform>%n person would be updated; their password remains valid.</numerusform>
            <numerusform>%n people would be updated; their passwords remain valid.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people have an account already and would be left as they are.</source>
        <translation>
            <numerusform>%n person has an account already and would be left as it is.</numerusform>
            <numerusform>%n people have an account already and would be left as they are.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passwords would be made. They are shown once, right after the import, to be printed as slips.</source>
        <translation>
            <numerusform>%n password would be made. It is shown once, right after the import, to be printed as a slip.</numerusform>
            <numerusform>%n passwords would be made. They are shown once, right after the import, to be printed as slips.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people would no longer be administrators.</source>
        <translation>
            <numerusform>%n person would no longer be an administrator.</numerusform>
            <numerusform>%n people would no longer be administrators.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people are listed under an earlier login name and are recognised by it.</source>
        <translation>
            <numerusform>%n person is listed under an earlier login name and is recognised by it.</numerusform>
            <numerusform>%n people are listed under an earlier login name and are recognised by it.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is not certain who is meant in %n more lines. Point at the login name in the table to read why.</source>
        <translation>
            <numerusform>It is not certain who is meant in %n more line. Point at the login name in the table to read why.</numerusform>
            <numerusform>It is not certain who is meant in %n more lines. Point at the login name in the table to read why.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people are listed under an earlier full name and keep today&apos;s name. To give somebody an earlier name back, edit the person.</source>
        <translation>
            <numerusform>%n person is listed under an earlier full name and keeps today&apos;s name. To give somebody an earlier name back, edit the person.</numerusform>
            <numerusform>%n people are listed under an earlier full name and keep today&apos;s name. To give somebody an earlier name back, edit the person.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more people would get a different full name; the table shows them.</source>
        <translation>
            <numerusform>%n more person would get a different full name; the table shows them.</numerusform>
            <numerusform>%n more people would get different full names; the table shows them.</numerusform>
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
    <name>StationRecord</name>
    <message numerus="yes">
        <source>Measured values and their limits, the worst of %n finger(s)</source>
        <translation>
            <numerusform>Measured values and their limits, on %n finger</numerusform>
            <numerusform>Measured values and their limits, the worst of %n fingers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StationWords</name>
    <message numerus="yes">
        <source>The loop does not run on time: %n tick(s) were skipped. Close other programs, or permit real-time priority.</source>
        <translation>
            <numerusform>The loop does not run on time: %n tick was skipped. Close other programs, or permit real-time priority.</numerusform>
            <numerusform>The loop does not run on time: %n ticks were skipped. Close other programs, or permit real-time priority.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StorageWords</name>
    <message numerus="yes">
        <source>The check found %n error(s). Nothing was changed. Keep this database as it is and restore a backup that passes the check.</source>
        <translation>
            <numerusform>The check found %n error. Nothing was changed. Keep this database as it is and restore a backup that passes the check.</numerusform>
            <numerusform>The check found %n errors. Nothing was changed. Keep this database as it is and restore a backup that passes the check.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudyReport</name>
    <message numerus="yes">
        <source>SIMULATED: %n participant(s) are programs, not people</source>
        <translation>
            <numerusform>SIMULATED: %n participant is a program, not a person</numerusform>
            <numerusform>SIMULATED: %n participants are programs, not people</numerusform>
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
        <source>With only %n participant(s), differences between people are very uncertain.</source>
        <translation>
            <numerusform>With only %n participant, differences between people are very uncertain.</numerusform>
            <numerusform>With only %n participants, differences between people are very uncertain.</numerusform>
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
        <source>%n simulated participant(s) are left out: the group contains only people.</source>
        <translation>
            <numerusform>%n simulated participant is left out: the group contains only people.</numerusform>
            <numerusform>%n simulated participants are left out: the group contains only people.</numerusform>
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
        <source>Only %n trial(s): the interval is wide and depends partly on prior assumptions.</source>
        <translation>
            <numerusform>Only %n trial: the interval is wide and depends partly on prior assumptions.</numerusform>
            <numerusform>Only %n trials: the interval is wide and depends partly on prior assumptions.</numerusform>
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
        <source>With only %n setting(s), the spread of the settings is very uncertain.</source>
        <translation>
            <numerusform>With only %n setting, the spread of the settings is very uncertain.</numerusform>
            <numerusform>With only %n settings, the spread of the settings is very uncertain.</numerusform>
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
        <source>With only %n answer(s), the result is very uncertain.</source>
        <translation>
            <numerusform>With only %n answer, the result is very uncertain.</numerusform>
            <numerusform>With only %n answers, the result is very uncertain.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With only %n participant(s) with an exponent, differences between people are very uncertain.</source>
        <translation>
            <numerusform>With only %n participant with an exponent, differences between people are very uncertain.</numerusform>
            <numerusform>With only %n participants with an exponent, differences between people are very uncertain.</numerusform>
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
        <source>%n mark(s) come from a simulated observer: nothing was rendered.</source>
        <translation>
            <numerusform>%n mark comes from a simulated observer: nothing was rendered.</numerusform>
            <numerusform>%n marks come from a simulated observer: nothing was rendered.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) were simulated without rendering: the observers knew the values and felt nothing.</source>
        <translation>
            <numerusform>%n participant was simulated without rendering: the observer knew the values and felt nothing.</numerusform>
            <numerusform>%n participants were simulated without rendering: the observers knew the values and felt nothing.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Objects were shown to %n participant(s), not felt. Such runs are included on purpose: each counts in the group if its answers give a value.</source>
        <translation>
            <numerusform>Objects were shown to %n participant, not felt. Such runs are included on purpose: each counts in the group if its answers give a value.</numerusform>
            <numerusform>Objects were shown to %n participants, not felt. Such runs are included on purpose: each counts in the group if its answers give a value.</numerusform>
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
        <source>The computer could not keep up and %n sample(s) were lost. The rest is kept and can be played back. The session does not count towards passing; close other programs before the next attempt.</source>
        <translation>
            <numerusform>The computer could not keep up and %n sample was lost. The rest is kept and can be played back. The session does not count towards passing; close other programs before the next attempt.</numerusform>
            <numerusform>The computer could not keep up and %n samples were lost. The rest is kept and can be played back. The session does not count towards passing; close other programs before the next attempt.</numerusform>
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
    <name>chiron::desktop::CheckPage</name>
    <message numerus="yes">
        <source>%n trial(s) that count</source>
        <translation>
            <numerusform>%n trial that counts</numerusform>
            <numerusform>%n trials that count</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n repeated</source>
        <translation>
            <numerusform>%n repeated</numerusform>
            <numerusform>%n repeated</numerusform>
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
    <message numerus="yes">
        <source>Ready. Force is felt. %n device(s) connected.</source>
        <translation>
            <numerusform>Ready. Force is felt. %n device connected.</numerusform>
            <numerusform>Ready. Force is felt. %n devices connected.</numerusform>
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
        <source>The device cannot render all differences: %n remain.</source>
        <translation>
            <numerusform>The device cannot render all differences: %n remains.</numerusform>
            <numerusform>The device cannot render all differences: %n remain.</numerusform>
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
        <source>The program ended unexpectedly during session %1 (%2, %3). The session was saved as interrupted: %n sample(s) were kept and can be played back. The session does not count.</source>
        <translation>
            <numerusform>The program ended unexpectedly during session %1 (%2, %3). The session was saved as interrupted: %n sample was kept and can be played back. The session does not count.</numerusform>
            <numerusform>The program ended unexpectedly during session %1 (%2, %3). The session was saved as interrupted: %n samples were kept and can be played back. The session does not count.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) withdrew from a study and asked for their recordings to be erased. Under People, choose &quot;Erase a participant&quot;.</source>
        <translation>
            <numerusform>%n participant withdrew from a study and asked for the recordings to be erased. Under People, choose &quot;Erase a participant&quot;.</numerusform>
            <numerusform>%n participants withdrew from a study and asked for their recordings to be erased. Under People, choose &quot;Erase a participant&quot;.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) to review</source>
        <translation>
            <numerusform>%n session to review</numerusform>
            <numerusform>%n sessions to review</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Comments: unread on %n session(s)</source>
        <translation>
            <numerusform>Comments: unread on %n session</numerusform>
            <numerusform>Comments: unread on %n sessions</numerusform>
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
    <name>chiron::desktop::PaletteFinder</name>
    <message numerus="yes">
        <source>%1 (%n more; type more letters)</source>
        <translation>
            <numerusform>%1 (%n more; type more letters)</numerusform>
            <numerusform>%1 (%n more; type more letters)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PersonPage</name>
    <message numerus="yes">
        <source>Replayed from its log, the procedure makes the same %n choice(s).</source>
        <translation>
            <numerusform>Replayed from its log, the procedure makes the same %n choice.</numerusform>
            <numerusform>Replayed from its log, the procedure makes the same %n choices.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PreviewPage</name>
    <message numerus="yes">
        <source>median of %n run(s)</source>
        <translation>
            <numerusform>%n run</numerusform>
            <numerusform>median of %n runs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>standard error of the bias of %n participant(s), if they do not differ</source>
        <translation>
            <numerusform>standard error of the bias of %n participant</numerusform>
            <numerusform>standard error of the bias of %n participants, if they do not differ</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ProgressScreen</name>
    <message numerus="yes">
        <source>No session in the last %n day(s)</source>
        <translation>
            <numerusform>No session in the last %n day</numerusform>
            <numerusform>No session in the last %n days</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n person</numerusform>
            <numerusform>%n people</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n person(s) in all.</source>
        <translation>
            <numerusform>%n person in all.</numerusform>
            <numerusform>%n people in all.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ProgressTable</name>
    <message numerus="yes">
        <source>Level %1, %n attempt(s)</source>
        <translation>
            <numerusform>Level %1, %n attempt</numerusform>
            <numerusform>Level %1, %n attempts</numerusform>
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
    <message numerus="yes">
        <source>%1: median %2, from %3 to %4, of %n participant(s)</source>
        <translation>
            <numerusform>%1: median %2, from %3 to %4, of %n participant</numerusform>
            <numerusform>%1: median %2, from %3 to %4, of %n participants</numerusform>
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
        <source>%n ranking(s) contained ties.</source>
        <translation>
            <numerusform>%n ranking contained a tie.</numerusform>
            <numerusform>%n rankings contained ties.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RosterDialog</name>
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
        <source>Importing %n people …</source>
        <translation>
            <numerusform>Importing %n person …</numerusform>
            <numerusform>Importing %n people …</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people were updated.</source>
        <translation>
            <numerusform>%n person was updated.</numerusform>
            <numerusform>%n people were updated.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RulesPage</name>
    <message numerus="yes">
        <source>%1: %n trial(s) that count</source>
        <translation>
            <numerusform>%1: %n trial that counts</numerusform>
            <numerusform>%1: %n trials that count</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: at most %n trial(s) that count</source>
        <translation>
            <numerusform>%1: at most %n trial that counts</numerusform>
            <numerusform>%1: at most %n trials that count</numerusform>
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
    <message numerus="yes">
        <source>%n session(s) to review</source>
        <translation>
            <numerusform>%n session to review</numerusform>
            <numerusform>%n sessions to review</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SideBar</name>
    <message numerus="yes">
        <source>%1: %n session(s) with new comments</source>
        <translation>
            <numerusform>%1: %n session with new comments</numerusform>
            <numerusform>%1: %n sessions with new comments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StorageScreen</name>
    <message numerus="yes">
        <source>%1 from %n session(s)</source>
        <translation>
            <numerusform>%1 from %n session</numerusform>
            <numerusform>%1 from %n sessions</numerusform>
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
        <source>Not saved yet: %n entr(y/ies) must be corrected first. %1</source>
        <translation>
            <numerusform>Not saved yet: %n entry must be corrected first. %1</numerusform>
            <numerusform>Not saved yet: %n entries must be corrected first. %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrainingScreen</name>
    <message numerus="yes">
        <source>%n trial(s). The clock starts when you press Go or move the tool with a key.</source>
        <translation>
            <numerusform>%n trial. The clock starts when you press Go or move the tool with a key.</numerusform>
            <numerusform>%n trials. The clock starts when you press Go or move the tool with a key.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s). The clock starts when you press Continue.</source>
        <translation>
            <numerusform>%n trial. The clock starts when you press Continue.</numerusform>
            <numerusform>%n trials. The clock starts when you press Continue.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s). The clock starts when you press Go.</source>
        <translation>
            <numerusform>%n trial. The clock starts when you press Go.</numerusform>
            <numerusform>%n trials. The clock starts when you press Go.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrialsScreen</name>
    <message numerus="yes">
        <source>Rest your hand. You can continue in %n second(s).</source>
        <translation>
            <numerusform>Rest your hand. You can continue in %n second.</numerusform>
            <numerusform>Rest your hand. You can continue in %n seconds.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Free minute: try the controls. Nothing counts yet. %n second(s) left.</source>
        <translation>
            <numerusform>Free minute: try the controls. Nothing counts yet. %n second left.</numerusform>
            <numerusform>Free minute: try the controls. Nothing counts yet. %n seconds left.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The free minute ends in %n second(s). Then you say when the trials begin.</source>
        <translation>
            <numerusform>The free minute ends in %n second. Then you say when the trials begin.</numerusform>
            <numerusform>The free minute ends in %n seconds. Then you say when the trials begin.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>First come %n practice trial(s), which do not count.</source>
        <translation>
            <numerusform>First comes %n practice trial, which does not count.</numerusform>
            <numerusform>First come %n practice trials, which do not count.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Thank you. %n more part(s) follow. Please call the experimenter, who decides when the next one begins.</source>
        <translation>
            <numerusform>Thank you. %n more part follows. Please call the experimenter, who decides when it begins.</numerusform>
            <numerusform>Thank you. %n more parts follow. Please call the experimenter, who decides when the next one begins.</numerusform>
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
